#pragma once

#include "reports/page/page_content.h"
#include "reports/page/page_texts.h"

namespace pendular {

/// Returns the words and tables of a page.
PageTexts page_texts(const PageContent& content);

}  // namespace pendular
