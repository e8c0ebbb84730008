#include "data/recordings/stated_role.h"

namespace pendular {

std::string stated_role(const Block& block, const FileFormat& format) {
    for (const auto& [role, intervals] : format.roles)
        for (const std::string& interval : intervals)
            if (interval == std::to_string(block.number) || interval == block.name ||
                interval == block.test)
                return role;
    return "";
}

}  // namespace pendular
