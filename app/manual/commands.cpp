#include "app/manual/commands.h"

#include "app/command.h"

namespace pendular::app {

std::vector<OptionDeclaration> DeclaredCommand::options() const {
    std::vector<OptionDeclaration> all;
    for (const OptionSection& section : declaration.sections) {
        all.insert(all.end(), section.options.begin(), section.options.end());
    }
    return all;
}

std::vector<DeclaredCommand> declared_commands() {
    std::vector<DeclaredCommand> result;
    for (const CommandGroup& group : command_groups()) {
        for (const Command& command : group.commands) {
            result.push_back({std::string(command.name), std::string(command.summary),
                              group.heading, declaration_of(command.run)});
        }
    }
    return result;
}

}  // namespace pendular::app
