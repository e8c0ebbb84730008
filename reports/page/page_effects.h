#pragma once

#include "reports/page/page_content.h"
#include "reports/page/page_texts.h"

namespace pendular {

/// Returns the section on the effects in question: what speaks for each, pictures of what they do,
/// the models that explain the readings, and the tests of all known effects.
PageSection effects_section(const PageContent& content);

}  // namespace pendular
