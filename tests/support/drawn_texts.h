#pragma once

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/text_width.h"

namespace pendular::figure_check {

/// Rectangle on the page [inch], with y upwards.
struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;

    /// Whether two boxes overlap by more than `slack` [inch] in both directions.
    bool overlaps(const Box& other, double slack = 0.015) const {
        return std::min(right, other.right) - std::max(left, other.left) > slack &&
               std::min(top, other.top) - std::max(bottom, other.bottom) > slack;
    }
    bool within(const Box& other, double slack) const {
        return left >= other.left - slack && right <= other.right + slack &&
               bottom >= other.bottom - slack && top <= other.top + slack;
    }
};

/// Text that gnuplot has drawn.
struct DrawnText {
    std::string text;
    Box box;
    double size = 0;  ///< [1/96 inch], of sub- and superscripts that of the line
};

namespace detail {

/// Numbers in "translate(420.00,22.23) rotate(-90.00)".
inline std::vector<double> numbers_in(std::string text) {
    std::ranges::replace_if(
        text,
        [](char c) { return !std::isdigit(static_cast<unsigned char>(c)) && c != '.' && c != '-'; },
        ' ');
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (double number = 0; stream >> number;)
        numbers.push_back(number);
    return numbers;
}

inline DrawnText text_of(const pugi::xml_node& group, double page_height) {
    DrawnText drawn{.text = {}, .box = {}, .size = group.attribute("font-size").as_double()};
    double width = 0;
    for (const auto& span : group.child("text").children("tspan")) {
        const std::string part = span.text().get();
        drawn.text += part;
        width += text_width(plain_text(part), span.attribute("font-size").as_double(drawn.size));
    }
    const std::vector<double> place = numbers_in(group.attribute("transform").value());
    const std::string anchor = group.attribute("text-anchor").as_string("start");
    const double ascent = 0.73 * drawn.size / dots_of_inch,
                 descent = 0.2 * drawn.size / dots_of_inch;
    const double before = anchor == "end" ? width : anchor == "middle" ? width / 2 : 0;
    const double x = place.at(0) / dots_of_inch, y = page_height - place.at(1) / dots_of_inch;
    const bool upright = place.size() > 2 && place[2] != 0;  // the label of a y axis
    drawn.box = upright ? Box{x - ascent, y - before, x + descent, y - before + width}
                        : Box{x - before, y - descent, x - before + width, y + ascent};
    return drawn;
}

}  // namespace detail

/// Returns the texts of an SVG that gnuplot has drawn, with the boxes that they fill in DejaVu
/// Sans.
inline std::vector<DrawnText> drawn_texts(const std::string& svg, double page_height) {
    pugi::xml_document document;
    document.load_string(svg.c_str(), pugi::parse_default | pugi::parse_ws_pcdata);
    std::vector<DrawnText> texts;
    for (const auto& found : document.select_nodes("//g[text]")) {
        DrawnText text = detail::text_of(found.node(), page_height);
        if (text.text.find_first_not_of(" \n\t") != std::string::npos) texts.push_back(text);
    }
    return texts;
}

}  // namespace pendular::figure_check
