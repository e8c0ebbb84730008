#include "reports/page/effect_picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pendular {
namespace {

/// Drawing of 220 x 140 units, in which marked parts have the colour of accents.
class Sketch {
  public:
    enum class Tone { plain, marked };

    void path(const std::string& d, Tone ink = Tone::plain, bool dashed = false) {
        body_ += fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{}"{}/>)", d,
                             colour(ink), ink == Tone::marked ? 2.4 : 1.2,
                             dashed ? R"( stroke-dasharray="4 3")" : "");
    }
    void circle(double x, double y, double r, Tone ink = Tone::plain, bool dashed = false) {
        body_ += fmt::format(
            R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="none" stroke="{}" stroke-width="{}"{}/>)",
            x, y, r, colour(ink), ink == Tone::marked ? 2 : 1,
            dashed ? R"( stroke-dasharray="3 2")" : "");
    }
    /// Arrow from (x0, y0) to (x1, y1).
    void arrow(double x0, double y0, double x1, double y1, Tone ink = Tone::plain) {
        const double length = std::hypot(x1 - x0, y1 - y0);
        const double ux = (x1 - x0) / length, uy = (y1 - y0) / length;
        constexpr double head = 6, half = 3.2;
        path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}",
                         x0, y0, x1, y1, x1 - head * ux + half * uy, y1 - head * uy - half * ux, x1,
                         y1, x1 - head * ux - half * uy, y1 - head * uy + half * ux),
             ink);
    }
    void text(double x, double y, const std::string& words, Tone ink = Tone::plain) {
        body_ += fmt::format(
            R"(<text x="{}" y="{}" text-anchor="middle" font-size="12" font-family="system-ui, sans-serif" fill="{}"{}>{}</text>)",
            x, y, colour(ink), ink == Tone::marked ? R"( font-weight="650")" : "", words);
    }
    std::string svg(const std::string& label) const {
        return fmt::format(
            R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 220 140" width="220" height="140" role="img" aria-label="{}">{}</svg>)",
            label, body_);
    }

  private:
    static const char* colour(Tone ink) {
        return ink == Tone::marked ? "var(--accent, #0b62a4)" : "var(--soft, #565656)";
    }
    std::string body_;
};

using Tone = Sketch::Tone;

Tone marked(bool yes) {
    return yes ? Tone::marked : Tone::plain;
}

/// Shown quantities that an effect of the instrument changes.
struct Changed {
    bool torque = false, force = false, height = false, speed = false, liquid = false,
         beads = false;
};

/// Values of the parameters that show an effect: away from neutral by the size that matters.
std::vector<double> visible_values(const Effect& effect) {
    std::vector<double> values;
    for (const EffectParameter& p : effect.parameters) {
        const double away = p.neutral + p.smallest_of_interest;
        values.push_back(p.is_switch() ? 1 : away <= p.upper ? away : p.lower);
    }
    return values;
}

/// Compares a usual state of a cell with what the effect shows of it.
Changed changed_by(const Effect& effect) {
    // A cell as in `pendular virtual-lab`, ten minutes after the first recording began.
    const CellState before{.torque = 0.05,
                           .normal_force = 5,
                           .height = 0.018,
                           .angular_velocity = 1,
                           .liquid_content = 0.03,
                           .bead_volume = 5.7e-5,
                           .time = 600,
                           .inner_radius = 0.021,
                           .outer_radius = 0.045,
                           .density = 1050,
                           .diameter = 5e-4};
    const std::vector<double> values = visible_values(effect);
    const CellState after =
        std::get<ChangeInstrument>(effect.change).show(before, {effect.parameters, values});
    const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(b); };
    return {.torque = differ(after.torque, before.torque),
            .force = differ(after.normal_force, before.normal_force),
            .height = differ(after.height, before.height),
            .speed = differ(after.angular_velocity, before.angular_velocity),
            .liquid = differ(after.liquid_content, before.liquid_content),
            .beads = differ(after.bead_volume, before.bead_volume)};
}

bool in_the_cell(const Effect& effect) {
    return std::get<ChangeInstrument>(effect.change).where == ChangeInstrument::Where::grains;
}

/// Whether an effect is of the walls: only friction there changes the torque of the grains.
bool at_the_walls(const Effect& effect, const Changed& c) {
    return in_the_cell(effect) && c.torque;
}

/// Inside of the drawn cell.
constexpr double cell_left = 55, cell_right = 145, cell_top = 44, cell_bottom = 128;

void draw_grains(Sketch& sketch, const Effect& effect, const Changed& c) {
    constexpr double radius = 7;
    const bool heavy = in_the_cell(effect) && c.force && !c.torque;
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            const double x = cell_left + radius + 1 + 14.4 * column + (row % 2 == 0 ? 0 : 4);
            const double y = cell_bottom - radius - 13 * row;
            const bool gone = c.beads && row == 5 && column % 2 == 1;
            sketch.circle(x, y, radius, marked(gone), gone);
            if (heavy && row % 3 == 2 && column % 2 == 0) {
                sketch.arrow(x, y - 5, x, y + 8, Tone::marked);
            }
            if (c.liquid && row == 5 && column % 2 == 0) {
                sketch.arrow(x + 4, y - 8, x + 8, y - 24, Tone::marked);
            }
        }
    }
}

/// The annulus in section, with lid, torque T, normal force F, height H and speed of the lid.
void draw_cell(Sketch& sketch, const Effect& effect) {
    const Changed c = changed_by(effect);
    const bool walls = at_the_walls(effect, c), transducer = !in_the_cell(effect);
    draw_grains(sketch, effect, c);
    sketch.path(fmt::format("M{0} {2}V{3}H{1}V{2}", cell_left - 1, cell_right + 5, cell_top - 12,
                            cell_bottom + 1));
    if (walls) {
        // Where shear is uneven, only a layer under the lid rubs.
        const double lowest = effect.of_uneven_shear ? (cell_top + cell_bottom) / 2 : cell_bottom;
        for (const double x : {cell_left - 6, cell_right + 10})
            sketch.arrow(x, lowest - 10, x, cell_top + 8, Tone::marked);
    }
    sketch.path(fmt::format("M{} {}h{}v8h-{}Z", cell_left, cell_top - 9, cell_right + 4 - cell_left,
                            cell_right + 4 - cell_left),
                marked(c.speed));
    if (c.speed)
        sketch.arrow(cell_left + 14, cell_top + 3, cell_right - 20, cell_top + 3, Tone::marked);
    const Tone torque = marked(c.torque && transducer), force = marked(c.force && transducer),
               height = marked(c.height);
    sketch.path("M112 26a18 6 0 1 0 22 -9", torque);
    sketch.path("M139 20l-5 -3l5 -5", torque);
    sketch.text(c.torque ? 178 : 120, 14, c.torque ? "T shown" : "T", torque);
    sketch.arrow(80, 4, 80, 33, force);
    sketch.text(c.force ? 46 : 68, 16, c.force ? "F shown" : "F", force);
    const double x = cell_right + 28;
    sketch.arrow(x, (cell_top + cell_bottom) / 2 - 8, x, cell_top, height);
    sketch.arrow(x, (cell_top + cell_bottom) / 2 + 8, x, cell_bottom, height);
    sketch.text(c.height ? x + 18 : x + 10, (cell_top + cell_bottom) / 2 + 4,
                c.height ? "H shown" : "H", height);
}

/// A table of readings, of which columns are shown changed.
void draw_table(Sketch& sketch, const Effect& effect) {
    const Changed c = changed_by(effect);
    const std::array<std::pair<const char*, bool>, 3> columns = {
        {{"s22", c.force}, {"s12", c.torque}, {"φ", c.height || c.beads}}};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const double x = 40 + 50 * static_cast<double>(k);
        const Tone ink = marked(columns[k].second);
        sketch.text(x + 22, 32, columns[k].first, ink);
        for (int row = 0; row < 4; ++row) {
            sketch.path(fmt::format("M{} {}h40", x + 2, 52 + 20 * row), ink);
        }
        sketch.path(fmt::format("M{} 40h44", x), ink);
    }
}

/// Two grains with centres at (x0, y) and (x1, y), and, with liquid, a bridge between them.
void draw_pair(Sketch& sketch, double gap, bool liquid, Tone bridge) {
    const double r = 36, x0 = 110 - r - gap / 2, x1 = 110 + r + gap / 2, y = 76;
    sketch.circle(x0, y, r);
    sketch.circle(x1, y, r);
    if (!liquid) return;
    const double half = 0.55, dx = r * std::cos(half), dy = r * std::sin(half);
    for (const double side : {-1.0, 1.0}) {
        sketch.path(fmt::format("M{:.1f} {:.1f}Q110 {:.1f} {:.1f} {:.1f}", x0 + dx, y + side * dy,
                                y + side * 0.5 * dy, x1 - dx, y + side * dy),
                    bridge);
    }
}

bool acts_on_liquid(const Effect& effect) {
    return effect.touches == Touches::wet || effect.fades_with_capillarity ||
           effect.given_by_liquid != nullptr;
}

void draw_turning(Sketch& sketch) {
    sketch.path("M58 50a30 30 0 0 1 32 4", Tone::marked);
    sketch.path("M84 48l6 6l-8 2", Tone::marked);
    sketch.path("M130 54a30 30 0 0 1 32 -4", Tone::marked);
    sketch.path("M136 56l-6 -2l4 -7", Tone::marked);
    sketch.path("M110 64v24", Tone::marked);
}

void draw_pairs(Sketch& sketch, const Effect& effect, const dem::ChangePairs& change) {
    const bool law = change.bridge_law != nullptr, wet = acts_on_liquid(effect);
    const bool apart = change.bridges_without_contact || law;
    draw_pair(sketch, apart ? 16 : 0, wet || apart || change.bridge,
              marked(apart || change.bridge || change.volume_in_history || change.damping_rate));
    if (change.volume_in_history) {
        sketch.path("M60 38q6 -14 16 -18M84 38q-2 -12 -4 -18", Tone::marked);
        sketch.text(64, 16, "large", Tone::marked);
        sketch.text(110, 110, "small", Tone::marked);
        return;
    }
    if (law) {
        sketch.arrow(96, 124, 102, 124, Tone::marked);
        sketch.arrow(124, 124, 118, 124, Tone::marked);
        sketch.text(110, 138, "D0", Tone::marked);
    }
    if (change.bridges_without_contact) {
        sketch.arrow(40, 22, 80, 22, Tone::marked);
        sketch.arrow(180, 22, 140, 22, Tone::marked);
    }
    if (change.limit) {
        sketch.arrow(106, 100, 106, 52, Tone::marked);
        sketch.arrow(114, 52, 114, 100, Tone::marked);
    }
    if (change.damping_rate) {
        sketch.arrow(74, 100, 74, 52, Tone::marked);
        sketch.arrow(146, 52, 146, 100, Tone::marked);
    } else if (change.contact_history > 0) {
        draw_turning(sketch);
    } else if (change.add) {
        sketch.arrow(62, 76, 100, 76, Tone::marked);
        sketch.arrow(158, 76, 120, 76, Tone::marked);
    }
}

void draw_sample(Sketch& sketch) {
    const std::array<std::array<double, 3>, 6> grains = {
        {{60, 96, 24}, {104, 104, 17}, {146, 94, 28}, {84, 58, 20}, {122, 56, 18}, {160, 46, 20}}};
    for (const auto& [x, y, r] : grains) {
        sketch.circle(x, y, r, Tone::marked);
        sketch.circle(x, y, 20, Tone::plain, true);
    }
}

void draw_flow(Sketch& sketch) {
    sketch.path("M40 20V120H200");
    sketch.path("M40 118C60 90 80 62 120 62S180 62 196 62");
    sketch.path("M40 118C54 60 72 24 88 30S120 62 196 62", Tone::marked, true);
    sketch.text(120, 136, "strain");
}

void draw(Sketch& sketch, const Effect& effect) {
    if (const auto* instrument = std::get_if<ChangeInstrument>(&effect.change)) {
        if (instrument->where == ChangeInstrument::Where::table) {
            draw_table(sketch, effect);
        } else {
            draw_cell(sketch, effect);
        }
    } else if (const auto* pairs = std::get_if<dem::ChangePairs>(&effect.change)) {
        draw_pairs(sketch, effect, *pairs);
    } else if (std::holds_alternative<dem::ChangeSample>(effect.change)) {
        draw_sample(sketch);
    } else if (std::holds_alternative<ChangeFlow>(effect.change)) {
        draw_flow(sketch);
    } else {
        draw_pair(sketch, 0, true, marked(effect.of_closure() || acts_on_liquid(effect)));
        if (effect.of_closure()) sketch.text(110, 20, "formula of the strength", Tone::marked);
    }
}

/// A text with the characters that XML reads as markup escaped.
std::string for_xml(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

}  // namespace

std::string cell_picture_in_words(const Effect& effect) {
    if (!effect.of_instrument()) return effect.name + ": " + effect.summary;
    const Changed c = changed_by(effect);
    std::vector<std::string> parts;
    const auto add = [&](bool yes, const char* words) {
        if (yes) parts.emplace_back(words);
    };
    add(c.torque, "torque");
    add(c.force, "normal force");
    add(c.height, "height");
    add(c.speed, "speed of the lid");
    add(c.liquid, "liquid content");
    add(c.beads, "amount of beads");
    return fmt::format("{}: {}. Changed: {}", effect.name, effect.summary, fmt::join(parts, ", "));
}

std::string cell_picture(const Effect& effect) {
    Sketch sketch;
    draw(sketch, effect);
    return sketch.svg(for_xml(cell_picture_in_words(effect)));
}

namespace {

/// Largest number that is no change: rounding errors of the predictions are some 1e-13, the
/// smallest change that a figure of an effect shows is some 1e-3.
constexpr double rounding = 1e-6;

/// Curves of a panel as lines in a frame, with the largest change times `unit` beside it and the
/// text `unit_text` behind that.
void draw_changes(Sketch& sketch, const Panel& panel, double frame_top, const std::string& label,
                  double unit, const std::string& unit_text) {
    constexpr double from = 60, to = 212, height = 54;
    double least = 0, greatest = 0, x0 = INFINITY, x1 = -INFINITY;
    const auto lines = [&](auto&& use) {
        for (const Curve& curve : panel.curves) {
            const bool line = curve.style != Curve::Style::band && curve.x.size() > 2;
            if (line) use(curve);
        }
    };
    lines([&](const Curve& curve) {
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            least = std::min(least, curve.y[k]), greatest = std::max(greatest, curve.y[k]);
            x0 = std::min(x0, curve.x[k]), x1 = std::max(x1, curve.x[k]);
        }
    });
    const double largest = greatest >= -least ? greatest : least;
    const bool changes = std::abs(largest) > rounding;
    if (!changes) least = -0.5, greatest = 0.5;
    const double size = greatest - least;
    const auto x_of = [&](double x) {
        return from + (to - from) * (panel.log_x ? std::log(x / x0) / std::log(x1 / x0)
                                                 : (x - x0) / (x1 - x0));
    };
    const auto y_of = [&](double y) {
        return frame_top + 4 + (height - 8) * (greatest - y) / size;
    };
    sketch.path(fmt::format("M{} {}V{}", from, frame_top, frame_top + height));
    sketch.path(fmt::format("M{} {:.1f}H{}", from, y_of(0), to), Tone::plain, true);
    bool first = true;
    lines([&](const Curve& curve) {
        std::string d;
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", x_of(curve.x[k]),
                             y_of(changes ? curve.y[k] : 0));
        }
        sketch.path(d, Tone::marked, !first);
        first = false;
    });
    // Room for a number such as "-0.00086" left of the frame.
    sketch.text(30, frame_top + height / 2, label);
    sketch.text(30, frame_top + height / 2 + 15,
                changes ? fmt::format("{:+.2g}{}", unit * largest, unit_text) : "0");
}

}  // namespace

std::string change_picture(const Figure& signature) {
    const std::size_t columns = signature.columns ? signature.columns : signature.panels.size() / 2;
    if (columns == 0 || signature.panels.size() < columns + 1) return "";
    Sketch sketch;
    draw_changes(sketch, signature.panels[0], 6, "Δμ", 1, " %");
    draw_changes(sketch, signature.panels[columns], 68, "Δφ", 1e-3, "");  // of 10^3 times it
    sketch.text(128, 136, "reduced pressure, log. →");
    return sketch.svg("Change of stress ratio and of solid fraction against the reduced pressure");
}

}  // namespace pendular
