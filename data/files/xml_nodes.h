#pragma once

#include <pugixml.hpp>
#include <string_view>

namespace pendular {

/// Returns the name of an element or attribute without its namespace.
inline std::string_view local_name(const char* name) {
    const std::string_view whole = name;
    return whole.substr(whole.find(':') + 1);  // npos + 1 is 0
}

/// Returns the first child with a name; an empty node if there is none.
inline pugi::xml_node child_named(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& each : node.children())
        if (local_name(each.name()) == name) return each;
    return {};
}

}  // namespace pendular
