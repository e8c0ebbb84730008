// Ways of spoiling the recordings of examples/wet, whose friction is 0.12: none may yield a
// confident wrong friction in silence. Each is refused (exit code 2), or said to be doubtful (exit
// code 3, or "believable": false and so in the first line), or it does no harm: the friction is
// right within three standard errors. The table is that of docs/validation.md.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/app_support.h"

namespace pendular::spoiled_recordings_test {

namespace fs = std::filesystem;

enum class Fate { refused, doubted, harmless };

std::string name_of(Fate fate) {
    return fate == Fate::refused ? "refused" : fate == Fate::doubted ? "doubted" : "no harm";
}

struct Spoiling {
    std::string name;
    std::function<void(const fs::path& study)> spoil;
    std::vector<Fate> allowed;
    std::string says = {};  ///< in what is printed
};

void PrintTo(const Spoiling& spoiling, std::ostream* out) {
    *out << spoiling.name;
}

/// A recording as text cells.
struct Cells {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    std::size_t column(const std::string& begins) const {
        for (std::size_t k = 0; k < header.size(); ++k) {
            if (header[k].starts_with(begins)) return k;
        }
        throw std::logic_error(begins);
    }
};

std::vector<std::string> split(const std::string& line, char by = ',') {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, by);)
        cells.push_back(cell);
    return cells;
}

Cells read(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    Cells cells{split(line), {}};
    while (std::getline(stream, line))
        cells.rows.push_back(split(line));
    return cells;
}

void write(const fs::path& file, const Cells& cells, const std::string& separator = ",") {
    std::ofstream stream(file);
    stream << fmt::format("{}\n", fmt::join(cells.header, separator));
    for (const auto& row : cells.rows)
        stream << fmt::format("{}\n", fmt::join(row, separator));
}

using Edit = std::function<void(Cells&)>;

/// Edits the recordings whose names begin so.
std::function<void(const fs::path&)> in(const std::string& begins, const Edit& edit) {
    return [=](const fs::path& study) {
        for (const auto& entry : fs::directory_iterator(study)) {
            const std::string name = entry.path().filename();
            if (!name.starts_with(begins) || entry.path().extension() != ".csv") continue;
            Cells cells = read(entry.path());
            edit(cells);
            write(entry.path(), cells);
        }
    };
}

std::function<void(const fs::path&)> in_all(const Edit& edit) {
    return in("", edit);
}

Edit each(const std::string& column, const std::function<double(double, std::size_t)>& change) {
    return [=](Cells& cells) {
        const std::size_t k = cells.column(column);
        for (std::size_t row = 0; row < cells.rows.size(); ++row)
            cells.rows[row][k] = fmt::format("{:.7g}", change(std::stod(cells.rows[row][k]), row));
    };
}

Edit times(const std::string& column, double factor) {
    return each(column, [=](double value, std::size_t) { return factor * value; });
}

Edit swapped(const std::string& a, const std::string& b) {
    return [=](Cells& cells) {
        std::swap(cells.header[cells.column(a)], cells.header[cells.column(b)]);
    };
}

std::function<void(const fs::path&)> in_study(const std::string& what, const std::string& by) {
    return [=](const fs::path& study) {
        std::string text = content_of(study / "study.toml");
        std::size_t at = text.find(what);
        if (at == std::string::npos) throw std::logic_error(what);
        for (; at != std::string::npos; at = text.find(what, at + by.size()))
            text.replace(at, what.size(), by);
        std::ofstream(study / "study.toml") << text;
    };
}

std::function<void(const fs::path&)> copies(const std::string& file, int count, bool linked) {
    return [=](const fs::path& study) {
        for (int k = 0; k < count; ++k) {
            const fs::path copy = study / fmt::format("dry_copy_{}.csv", k);
            linked ? fs::create_symlink(study / file, copy)
                   : static_cast<void>(fs::copy_file(study / file, copy));
        }
    };
}

const std::string torque = "Torque", force = "Normal force", gap = "Gap", speed = "Angular",
                  clock = "Time";
constexpr double turn = 6.283185307;
const std::vector<Fate> caught = {Fate::refused, Fate::doubted},
                        any = {Fate::refused, Fate::doubted, Fate::harmless},
                        right = {Fate::harmless};

const std::vector<Spoiling> spoilings = {
    {"nothing spoilt", [](const fs::path&) {}, right},
    {"torque in uN m read as mN m", in_all(times(torque, 1e3)), caught},
    {"torque in N m read as mN m", in_all(times(torque, 1e-3)), caught},
    {"torque in gf cm read as mN m", in_all(times(torque, 10.19716)), caught},
    {"torque in N m in one wet file", in("wet_0.03_2", times(torque, 1e-3)), caught},
    {"torque in uN m in one dry file", in("dry_2", times(torque, 1e3)), caught},
    {"torque ten times too large in one file", in("wet_0.007_1", times(torque, 10)), caught},
    {"torque twice too large", in_all(times(torque, 2)), caught},
    {"torque 30 % too large in one file", in("dry_1", times(torque, 1.3)), any},
    {"angular velocity in rpm read as rad/s", in_all(times(speed, 60 / turn)), caught},
    {"angular velocity in Hz read as rad/s", in_all(times(speed, 1 / turn)), caught},
    {"angular velocity in deg/s read as rad/s", in_all(times(speed, 360 / turn)), caught},
    {"angular velocity in rad/s read as rpm", in_all(times(speed, turn / 60)), any,
     "numbers in rad/s were read as rpm"},
    {"torque in N m in the files of one content", in("wet_0.03", times(torque, 1e-3)), caught,
     "a torque 1000 times larger"},
    {"torque 10 % too large in one file", in("wet_0.03_1", times(torque, 1.1)), any,
     "wet_0.03_1.csv, wet_0.03_2.csv differ"},
    {"two wet files swapped",
     [](const fs::path& study) {
         fs::rename(study / "wet_0.03_1.csv", study / "kept");
         fs::rename(study / "wet_0.007_2.csv", study / "wet_0.03_1.csv");
         fs::rename(study / "kept", study / "wet_0.007_2.csv");
     },
     any},
    {"angular velocity in rpm in one wet file", in("wet_0.03_1", times(speed, 60 / turn)), any},
    {"angular velocity in deg/s in one dry file", in("dry_1", times(speed, 360 / turn)), any},
    {"gap in um read as mm", in_all(times(gap, 1e3)), caught},
    {"gap in m read as mm", in_all(times(gap, 1e-3)), caught},
    {"gap in cm read as mm", in_all(times(gap, 0.1)), caught},
    {"gap in um read as mm in one file", in("dry_2", times(gap, 1e3)), any},
    {"gap zero off by 1 mm", in_all(each(gap, [](double v, std::size_t) { return v + 1; })),
     caught},
    {"force in mN read as N", in_all(times(force, 1e3)), caught},
    {"force in kN read as N", in_all(times(force, 1e-3)), caught},
    {"force in kgf read as N", in_all(times(force, 1 / 9.80665)), caught},
    {"force in gf read as N", in_all(times(force, 101.97)), caught},
    {"liquid content in percent", in_study("liquid_content = 0.03", "liquid_content = 3"), any},
    {"liquid contents swapped",
     [](const fs::path& study) {
         in_study("liquid_content = 0.03", "liquid_content = 0.04321")(study);
         in_study("liquid_content = 0.007", "liquid_content = 0.03")(study);
         in_study("liquid_content = 0.04321", "liquid_content = 0.007")(study);
     },
     any},
    {"a wet file called dry", in_study("liquid_content = 0.007", "liquid_content = 0.0"), any},
    {"bead mass ten times too large", in_study("\"60 g\"", "\"600 g\""), caught},
    {"bead mass ten times too small", in_study("\"60 g\"", "\"6 g\""), caught},
    {"bead mass 10 % too small", in_study("\"60 g\"", "\"54 g\""), caught},
    {"diameter in mm", in_study("\"500 um\"", "\"500 mm\""), caught},
    {"diameter ten times too small", in_study("\"500 um\"", "\"50 um\""), caught},
    {"density in g/cm^3 called kg/m^3", in_study("\"1050 kg/m^3\"", "\"1.05 kg/m^3\""), caught},
    {"radii swapped",
     [](const fs::path& study) {
         in_study("inner_radius = \"21 mm\"", "inner_radius = \"45 mm\"")(study);
         in_study("outer_radius = \"45 mm\"", "outer_radius = \"21 mm\"")(study);
     },
     {Fate::refused}},
    {"radii in cm",
     [](const fs::path& study) {
         in_study("\"21 mm\"", "\"21 cm\"")(study);
         in_study("\"45 mm\"", "\"45 cm\"")(study);
     },
     caught},
    {"outer radius 40 for 45 mm", in_study("\"45 mm\"", "\"40 mm\""), caught},
    {"torque and force swapped", in_all(swapped(torque, force)), caught},
    {"gap and force swapped", in_all(swapped(gap, force)), caught},
    {"torque constant", in_all(each(torque, [](double, std::size_t) { return 30.0; })), caught},
    {"torque zero", in_all(times(torque, 0)), caught},
    {"gap constant", in_all(each(gap, [](double, std::size_t) { return 18.9; })), any},
    {"one dry file three times", copies("dry_1.csv", 2, false), right},
    {"six links to one recording", copies("dry_1.csv", 6, true), right},
    {"time backwards",
     in_all([](Cells& cells) { std::reverse(cells.rows.begin(), cells.rows.end()); }), any},
    {"time in ms read as s", in_all(times(clock, 1e3)), any},
    {"time in min read as s", in_all(times(clock, 1.0 / 60)), any},
    {"negative rotation", in_all(times(speed, -1)), any},
    {"rotation of both signs",
     in_all(each(speed, [](double v, std::size_t row) { return row % 2 == 0 ? v : -v; })), caught},
    {"negative torque", in_all(times(torque, -1)), right},
    {"negative force", in_all(times(force, -1)), caught},
    {"one reading",
     [](const fs::path& study) {
         in_study("file = \"dry_*.csv\"", "file = \"dry_1.csv\"")(study);
         in("dry_1", [](Cells& cells) { cells.rows.resize(400); })(study);
     },
     any},
    {"decimal commas", in_all([](Cells& cells) {
         for (auto& row : cells.rows)
             for (auto& cell : row)
                 std::ranges::replace(cell, '.', ',');
     }),
     caught},
    {"last line cut",
     [](const fs::path& study) {
         const fs::path file = study / "dry_1.csv";
         fs::resize_file(file, fs::file_size(file) - 30);
     },
     any},
    {"half a file",
     in("wet_0.03_2", [](Cells& cells) { cells.rows.resize(cells.rows.size() / 2); }), any,
     "wet_0.03_2.csv ends after step"},
    {"a cell that is nan",
     in("dry_1", [](Cells& cells) { cells.rows[99][1] = "nan"; }),
     {Fate::harmless}},  // a missing value: the row is left out
    {"header in the middle",
     in("dry_1", [](Cells& cells) { cells.rows[99] = cells.header; }),
     {Fate::harmless}},  // a logger that was started again repeats its header
    {"no torque column",
     in_all([](Cells& cells) { cells.header[1] = "Other [1]"; }),
     {Fate::refused}},
    {"torque in Pa",
     in_all([](Cells& cells) { cells.header[1] = "Torque [Pa]"; }),
     {Fate::refused}},
    {"surface tension in N/m", in_study("\"20.6 mN/m\"", "\"20.6 N/m\""), any},
    {"one row in a hundred ten times too large",
     in_all(each(torque, [](double v, std::size_t row) { return row % 100 == 57 ? 10 * v : v; })),
     any},
    {"drag of 2 mN m", in_all(each(torque, [](double v, std::size_t) { return v + 2; })), caught},
};

class SpoiledRecordings : public testing::TestWithParam<Spoiling> {};

TEST_P(SpoiledRecordings, AreNotBelievedInSilence) {
    constexpr double friction = 0.12;
    const TemporaryFolder folder;
    const fs::path study = folder.path() / "study";
    fs::copy(fs::path(PENDULAR_SOURCE_DIR) / "examples/wet", study, fs::copy_options::recursive);
    fs::remove_all(study / "out");
    GetParam().spoil(study);
    const Outcome run = run_pendular("calibrate " + study.string() + " --no-confirm --json " +
                                     (folder.path() / "fit.json").string());
    ASSERT_NE(run.code, 1) << run.errors;
    Fate fate = Fate::refused;
    std::string value = run.errors.substr(0, run.errors.find('\n'));
    if (run.code != 2) {
        const auto json = nlohmann::json::parse(content_of(folder.path() / "fit.json"));
        const auto& fitted = json.at("parameters").at("friction");
        const double off = std::abs(fitted.at("value").get<double>() - friction) /
                           fitted.at("stderr").get<double>();
        const bool doubted = run.code == 3 || !json.at("believable").get<bool>();
        value = run.output.substr(0, run.output.find('\n'));
        if (doubted) {
            fate = Fate::doubted;
            EXPECT_THAT(
                value,
                testing::AnyOf(
                    testing::HasSubstr("Do not use the fitted intergranular friction coefficient"),
                    testing::HasSubstr("and not to be used for others")));
        } else {
            fate = Fate::harmless;
            EXPECT_LT(off, 3) << "confident and wrong: " << value;
        }
    }
    std::printf("| %s | %s |\n", GetParam().name.c_str(), name_of(fate).c_str());
    EXPECT_THAT(GetParam().allowed, testing::Contains(fate)) << value;
    EXPECT_THAT(run.output + run.errors, testing::HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(OfWetBeads, SpoiledRecordings, testing::ValuesIn(spoilings),
                         [](const auto& each) {
                             std::string name;
                             for (const char c : each.param.name)
                                 name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                             return name;
                         });

}  // namespace pendular::spoiled_recordings_test
