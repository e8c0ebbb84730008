#pragma once

#include <string>

#include "reports/page/page_content.h"

namespace pendular {

/// Results of a page as a reader copies them into a paper.
struct PasteTexts {
    /// Fitted parameters, cohesions and misfit, one a line: quantity, value, standard error, SI
    /// unit, remark.
    std::string csv;
    std::string latex;  ///< the same as a tabular, which needs no package
    /// Paragraph on model, fit, fidelity and simulations, then the references.
    std::string methods;
};

/// Returns the results of the study's model as it is fitted on its page.
PasteTexts paste_texts(const PageContent& content);

}  // namespace pendular
