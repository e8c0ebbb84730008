#include "reports/draw_figure.h"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <csignal>
#include <map>
#include <stdexcept>
#include <utility>

#include "data/files/file_access.h"
#include "data/files/write_whole.h"
#include "reports/figure_script.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

/// File format that gnuplot draws. A complete file contains `end` in its last bytes.
struct Format {
    std::string_view extension, terminal;
    double dots_per_inch;  ///< resolution of the size given to gnuplot; 0: size in inches
    std::string_view end;
};
/// In all formats, texts have 9 pt on the page: the terminals of cairo take 96 dots for an inch.
constexpr Format formats[] = {
    {"svg", "svg enhanced font 'DejaVu Sans,12' background rgb 'white' size", 96, "</svg>"},
    {"png",
     "pngcairo enhanced font 'DejaVu Sans,12' fontscale 1.25 linewidth 1.5 pointscale 1.5 "
     "size",
     160, "IEND"},
    {"pdf", "pdfcairo enhanced font 'DejaVu Sans,12' fontscale 0.75 linewidth 1.6 size", 0,
     "%%EOF"}};

/// File in which gnuplot draws a figure.
fs::path drawing(const fs::path& folder, const Figure& figure, const Format& format) {
    return folder / fmt::format("{}.{}", figure.name, format.extension);
}

std::string size_of(const Page& page, const Format& format) {
    return format.dots_per_inch > 0
               ? fmt::format("{:.0f},{:.0f}", page.width * format.dots_per_inch,
                             page.height * format.dots_per_inch)
               : fmt::format("{}in,{}in", page.width, page.height);
}

/// Content of a drawing; empty if the file is missing or incomplete.
std::string complete_drawing(const fs::path& file, std::string_view end) {
    std::error_code error;
    if (!fs::exists(file, error)) return "";
    std::string content = read_bytes(file, largest_table);
    // Behind `end` follow the check sum of a PNG and line ends.
    const std::string_view tail = std::string_view(content).substr(
        content.size() - std::min<std::size_t>(content.size(), 32));
    return tail.find(end) != std::string_view::npos ? content : "";
}

/// Lets writing to a program that has ended fail, during the life of the object, instead of ending
/// this program: gnuplot may be missing.
class BrokenPipesIgnored {
  public:
    BrokenPipesIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
    BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;
    ~BrokenPipesIgnored() { std::signal(SIGPIPE, before_); }

  private:
    void (*before_)(int);
};

/// Draws a figure by gnuplot into temporary files, one per format, and waits for gnuplot to end.
/// Gnuplot reads no settings of the user, and its warnings are discarded. The folder must be
/// absolute: gnuplot takes a file name that begins with '|' for a command and a leading '~' for the
/// home directory.
void run_gnuplot(const Figure& figure, const fs::path& folder) {
    const BrokenPipesIgnored ignored;
    Gnuplot gnuplot("gnuplot --default-settings 2>/dev/null");
    const Page page = page_of(figure);
    const Ink marks = marks_of(figure, page);
    gnuplot << "set encoding utf8\nset samples 2\n" << data_blocks(figure) << marks.data_blocks();
    for (const auto& format : formats) {
        gnuplot << "set terminal " << format.terminal << ' ' << size_of(page, format)
                << "\nset output " << gnuplot_string(drawing(folder, figure, format).string())
                << '\n'
                << script_of_page(figure, page, marks);
    }
}

}  // namespace

bool draw(const Figure& whole, const fs::path& folder) {
    const Figure figure = drawable(whole);
    if (figure.panels.empty()) return false;
    fs::create_directories(folder);
    write_whole(folder / (figure.name + ".csv"), numbers_table(figure));
    // A folder of its own: nobody else can have put a link there, which gnuplot would write
    // through.
    const PassingFolder drawn(fs::absolute(folder));
    run_gnuplot(figure, drawn.path());
    std::map<fs::path, std::string> files;
    for (const auto& format : formats) {
        std::string content = complete_drawing(drawing(drawn.path(), figure, format), format.end);
        if (content.empty()) {
            throw std::runtime_error(
                fmt::format("the figure {} is missing, all else is written: gnuplot could not draw "
                            "it; is gnuplot installed, and is there space on the disk?",
                            (folder / figure.name).string()));
        }
        files[drawing(folder, figure, format)] = std::move(content);
    }
    for (const auto& [file, content] : files) {
        write_whole(file, content);
    }
    return true;
}

std::vector<std::string> draw_all(const std::vector<Figure>& figures, const fs::path& folder) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) {
        if (draw(figure, folder)) names.push_back(figure.name);
    }
    return names;
}

}  // namespace pendular
