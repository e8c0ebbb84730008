#include "app/change_effects.h"

#include <fmt/format.h>

#include "reports/change_report.h"
#include "reports/draw_figure.h"
#include "reports/ladder_figure.h"
#include "workflow/rivals.h"

namespace pendular::app {

std::vector<std::filesystem::path> outputs_of_change() {
    return {"fit.json", "fit_runs.csv", "ladder.json", "figures"};
}

ChangedStudy change_effects(Session& session, Action action, const std::string& effect,
                            const FitOptions& fit, bool same_fidelity) {
    ChangeOptions options{.fit = fit, .same_fidelity = same_fidelity};
    if (action == Action::drop) return session.drop(effect, options);
    options.rivals = rivals_in(session.folder() / "diagnosis.json", session.study(), effect);
    return session.add(effect, options);
}

std::string answer_on(const ChangedStudy& changed) {
    const StudyChange& change = changed.change;
    const bool adds = change.change == Action::add;
    if (changed.written)
        return verdict_of(change, changed.before.ladder_step,
                          changed.comparable_after().ladder_step);
    return fmt::format("{} not {}: the fit {} it did not converge ({}). {} is unchanged.",
                       change.effect, adds ? "added" : "dropped", adds ? "with" : "without",
                       changed.after.calibration.fit.message, change.study.study().file.string());
}

std::string draw_ladder(const Ladder& ladder, const std::filesystem::path& folder) {
    const Figure figure = ladder_figure(ladder);
    draw(figure, folder);
    return figure.name;
}

}  // namespace pendular::app
