#pragma once

#include <string>

#include "analysis/ladder.h"
#include "reports/page/page_content.h"

namespace pendular {

/// Returns the page as one HTML file that needs no further files: verdict, figures, fit, effects,
/// shifts of the friction coefficient, ladder, next steps and provenance. In the figures, the
/// reader can switch the leading effects and change parameters with sliders.
std::string report_page(const PageContent& content);

/// Results from before, for a server that has none of its own yet.
struct EarlierResults {
    std::string page;  ///< HTML of a page (`report_page`); empty: none
    std::string when;  ///< local time at which it was written
    Ladder ladder;     ///< may be empty
};

/// Returns the page, of version 0, that a server shows until it has results: those of an earlier
/// page of the same version of Pendular, or else what the ladder says, marked as of then; or that
/// there are none. Of the earlier page, only texts and data are taken over, never markup.
/// @param version version of the program
std::string waiting_page(const std::string& study, const std::string& version,
                         const EarlierResults& earlier = {});

/// Returns a Content-Security-Policy that forbids loading anything outside the page.
/// @param served whether the page's script may send requests to its server
std::string page_policy(bool served);

}  // namespace pendular
