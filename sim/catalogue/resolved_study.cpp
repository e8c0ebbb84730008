#include "sim/catalogue/resolved_study.h"

#include <utility>

namespace pendular {

ResolvedStudy::ResolvedStudy(Study study)
    : ResolvedStudy(study, std::make_shared<EffectCatalogue>(study)) {}

ResolvedStudy::ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue)
    : study_(std::move(study)),
      catalogue_(std::move(catalogue)),
      effects_(catalogue_->active(study_)),
      direct_(direct_measurements(study_, *catalogue_)),
      uncertainties_(shared_uncertainties(study_)) {}

ResolvedStudy ResolvedStudy::changed_to(Study changed) const {
    return {std::move(changed), catalogue_};
}

}  // namespace pendular
