// Writes the manual pages of the program and its completion for shells into a folder, from the
// options that its commands declare:
//   write_manual FOLDER DATE
// FOLDER/man1/*.1, FOLDER/bash/pendular, FOLDER/zsh/_pendular, FOLDER/fish/pendular.fish
#include <cstdio>
#include <filesystem>

#include "app/manual/manual.h"
#include "data/files/write_whole.h"

int main(int count, char** words) {
    using namespace pendular;
    if (count != 3) {
        std::fputs("usage: write_manual FOLDER DATE\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = words[1];
    const app::ManHeading heading{.date = words[2], .version = PENDULAR_VERSION};
    const auto commands = app::declared_commands();
    write_whole(folder / "bash/pendular", app::bash_completion(commands));
    write_whole(folder / "zsh/_pendular", app::zsh_completion(commands));
    write_whole(folder / "fish/pendular.fish", app::fish_completion(commands));
    write_whole(folder / "man1/pendular.1", app::man_page_of_program(commands, heading));
    for (const app::DeclaredCommand& command : commands) {
        write_whole(folder / "man1" / ("pendular-" + command.name + ".1"),
                    app::man_page_of(command, heading));
    }
}
