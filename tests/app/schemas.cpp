// Whatever the program writes as JSON is what docs/reference says of it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "tests/support/app_support.h"

namespace app_schemas_test {

using nlohmann::json;
using nlohmann::ordered_json;
using pendular::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path reference = PENDULAR_SOURCE_DIR "/docs/reference";

json schema_named(const std::string& kind) {
    return json::parse(content_of(reference / (kind + ".schema.json")));
}

/// Violations of a schema by a document, one line each; empty: none.
std::string violations(const json& document, const json& schema) {
    valijson::Schema parsed;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), parsed);
    valijson::ValidationResults results;
    valijson::Validator().validate(parsed, valijson::adapters::NlohmannJsonAdapter(document),
                                   &results);
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        for (const std::string& part : error.context) {
            text += part;
        }
        text += ": " + error.description + "\n";
    }
    return text;
}

/// Expects a document of this kind, its format first.
void expect_valid(const std::string& text, const std::string& kind) {
    const ordered_json document = ordered_json::parse(text, nullptr, false);
    ASSERT_TRUE(document.is_object()) << kind << ": " << text.substr(0, 200);
    EXPECT_EQ(document.begin().key(), "format") << kind;
    EXPECT_EQ(violations(json::parse(text), schema_named(kind)), "") << kind;
}

/// Every schema within a schema that says what a value is, with where it stands. Schemas of `$defs`
/// are looked at once, not wherever "$ref" names them.
void for_each_value(const json& schema, const std::string& place,
                    const std::function<void(const json&, const std::string&)>& look) {
    if (schema.contains("$ref")) return;
    if (!schema.contains("type") && schema.contains("oneOf")) {
        for (const json& each : schema["oneOf"])
            for_each_value(each, place, look);
        return;
    }
    ASSERT_TRUE(schema.contains("type")) << place;
    look(schema, place);
    if (schema.contains("$defs")) {
        for (const auto& [key, value] : schema["$defs"].items()) {
            for_each_value(value, place + "#" + key, look);
        }
    }
    if (schema.contains("properties")) {
        for (const auto& [key, value] : schema["properties"].items()) {
            EXPECT_TRUE(value.contains("description")) << place << "/" << key;
            for_each_value(value, place + "/" + key, look);
        }
    }
    if (schema.contains("items")) for_each_value(schema["items"], place + "/items", look);
    if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
        for_each_value(schema["additionalProperties"], place + "/*", look);
    }
}

bool may_be(const json& schema, const std::string& type) {
    const json& types = schema["type"];
    return types == type ||
           (types.is_array() && std::ranges::find(types, json(type)) != types.end());
}

TEST(Schemas, DescribeEveryKeyWithItsUnit) {
    std::size_t schemas = 0;
    for (const auto& entry : fs::directory_iterator(reference)) {
        if (!entry.path().filename().string().ends_with(".schema.json")) continue;
        ++schemas;
        const json schema = json::parse(content_of(entry.path()));
        EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#");
        for_each_value(schema, entry.path().filename(),
                       [](const json& value, const std::string& place) {
                           if (may_be(value, "number") || may_be(value, "integer")) {
                               EXPECT_THAT(value.value("description", ""),
                                           testing::MatchesRegex(".*\\[.+\\].*"))
                                   << place;
                           }
                           if (may_be(value, "object")) {
                               EXPECT_TRUE(value.contains("additionalProperties"))
                                   << place;  // no unknown keys
                           }
                       });
    }
    EXPECT_GE(schemas, 17u);
}

TEST(Schemas, RefuseKeysTheyDoNotKnowAndNumbersThatAreNull) {
    json document = {{"format", 2}, {"added", 3}, {"runs", 8}};
    EXPECT_EQ(violations(document, schema_named("runs-added")), "");
    document["more"] = 1;
    EXPECT_NE(violations(document, schema_named("runs-added")), "");
    document.erase("more");
    document["runs"] = nullptr;
    EXPECT_NE(violations(document, schema_named("runs-added")), "");
    document["runs"] = 8, document["format"] = 3;
    EXPECT_NE(violations(document, schema_named("runs-added")), "");
}

/// Runs the program and expects JSON of this kind on its standard output.
std::string expect_output(const std::string& words, const std::string& kind) {
    const Outcome run = run_pendular(words + " --quiet --json -");
    EXPECT_EQ(run.code, 0) << words << "\n" << run.errors;
    expect_valid(run.output, kind);
    return run.output;
}

class JsonOutput : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    std::string copied(const std::string& example) const {
        fs::copy(fs::path(PENDULAR_SOURCE_DIR "/examples") / example, folder_.path() / example,
                 fs::copy_options::recursive);
        return path(example);
    }
    /// Dry readings as of friction 0.09, shear stresses short by a constant.
    std::string dry_study(const std::string& more) const {
        folder_.write("points.csv",
                      "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction "
                      "[1],solid_fraction_sd [1],inertial_number [1]\n"
                      "300,56.91,0.77,0.6189,0.0012,0.003\n1000,233.82,2.56,0.6198,0.0012,0.003\n"
                      "3000,750.66,7.67,0.6203,0.0012,0.003\n300,64.98,0.85,0.6138,0.0012,0.03\n"
                      "1000,266.67,2.84,0.6127,0.0012,0.03\n3000,831.46,8.53,0.6141,0.0012,0.03\n");
        folder_.write("study.toml",
                      "[grains]\ndiameter = \"500 um\"\ndensity = \"1050 kg/m^3\"\n[[readings]]\n"
                      "file = \"points.csv\"\nliquid_content = 0.0\n" +
                          more);
        return folder_.path().string();
    }
    const std::string effect_ =
        "[[effect]]\nname = \"lost-stress\"\nparameter = \"stress\"\nunit = \"Pa\"\n"
        "lower = -200.0\nupper = 200.0\nmatters = 10.0\n"
        "stress_ratio = \"stress_ratio - stress/normal_stress\"\n";
    const std::string cell_and_rig_ =
        "[cell]\ninner_radius = \"20 mm\"\nouter_radius = \"45 mm\"\nbead_mass = \"60 g\"\n"
        "[rig]\nnormal_stress = [\"0.1 kPa\", \"5 kPa\"]\ninertial_number = [0.003, 0.05]\n"
        "repeats = 5\n";

    const TemporaryFolder folder_;
};

const std::string small_run =
    "simulate --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1 --friction 0.2 "
    "--seed 7 ";

TEST_F(JsonOutput, OfRunsIsAsTheSchemasSay) {
    const std::string store = " --store " + path("runs.sqlite"),
                      other = " --store " + path("other.sqlite");
    const std::string run = expect_output(small_run + "--out " + path("run") + store, "run");
    EXPECT_EQ(content_of(path("run/run.json")), run);
    expect_output(small_run + "--reduced-pressure 4 --rolling-resistance.coefficient 0.1" + store,
                  "run");
    expect_output("runs list" + store, "runs");
    expect_output("reproduce" + store, "reproduction");
    expect_output("runs show 1" + store, "runs");
    expect_output("runs compare 1 2" + store, "runs-compare");
    ASSERT_EQ(run_pendular("runs export " + path("runs.csv") + store).code, 0);
    expect_output("runs import " + path("runs.csv") + other, "runs-added");
    expect_output("runs merge " + path("other.sqlite") + store, "runs-added");
    const auto file = folder_.write("few.toml",
                                    "[[grid]]\nfriction = [0.1]\ninertial_number = [0.5]\n"
                                    "stiffness_number = 300\nbeads = 100\nstrain = 1\n");
    const std::string plan =
        expect_output("campaign " + file.string() + " --dry-run" + store, "campaign");
    EXPECT_THAT(plan, HasSubstr("estimated_seconds"));
    expect_output("campaign " + file.string() + store, "campaign");
}

TEST_F(JsonOutput, OfPredictionsAndEffectsIsAsTheSchemasSay) {
    expect_output("predict --friction 0.09", "predict");
    expect_output(
        "predict --along reduced-pressure=0.5:20 --liquid-content 0.03 --points 3 --out " +
            path("along"),
        "predict");
    expect_output("effects", "effects");
    expect_output("effects torque-offset", "effect");
    expect_output("effects --study " + dry_study(effect_), "effects");
    expect_output("effects --manual " + path("manual"), "effects-manual");
}

TEST_F(JsonOutput, OfAVirtualLaboratoryIsAsTheSchemasSay) {
    const std::string truth = expect_output(
        "virtual-lab " + path("lab") +
            " --fidelity quick --dry --dry-normal-stresses \"1 kPa\" --inertial-numbers 0.5 "
            "--replicates 1 --rows 200 --friction 0.4 --torque-gain.gain 1.1",
        "truth");
    EXPECT_EQ(json::parse(content_of(path("lab/truth.json"))), json::parse(truth));
    expect_output("import " + path("lab"), "import");
}

TEST(Schemas, DescribeEveryShippedTruth) {
    std::size_t found = 0;
    for (const char* const folder : {"examples", "tests/data"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(PENDULAR_SOURCE_DIR) / folder)) {
            if (entry.path().filename() != "truth.json") continue;
            ++found;
            SCOPED_TRACE(entry.path());
            expect_valid(content_of(entry.path()), "truth");
        }
    }
    EXPECT_GE(found, 3u);
}

TEST_F(JsonOutput, OfAWetStudyIsAsTheSchemasSay) {
    const std::string study = copied("wet"), out = study + "/out/";
    expect_output("import " + study, "import");
    const std::string fit = expect_output("calibrate " + study + " --no-confirm --profile", "fit");
    expect_output("report " + study + " --switches 1", "report");
    EXPECT_EQ(content_of(out + "fit.json"), fit);
    EXPECT_LT(fit.size(), 100'000u);  // the runs stand elsewhere
    const std::string compared = expect_output("compare " + study, "compare");
    EXPECT_EQ(content_of(out + "compare.json"), compared);
}

TEST_F(JsonOutput, OfAServerIsAsTheSchemaSays) {
    const std::string study = copied("dry-recordings");
    // Ends the server by a signal once it has told its verdict.
    const std::string command = fmt::format(
        "{0} serve {1} --switches 0 --json - >{2} 2>{3} & server=$!; for k in $(seq 300); do grep "
        "-q "
        "effect {3} && break; sleep 0.1; done; kill -TERM $server; wait $server",
        PENDULAR_PROGRAM, study, path("address"), path("errors"));
    test_store();
    EXPECT_EQ(std::system(command.c_str()), 0) << content_of(path("errors"));
    const std::string text = content_of(path("address"));
    expect_valid(text, "serve");
    EXPECT_THAT(content_of(path("errors")), HasSubstr("The model describes the readings"));
    // By itself it writes its page alone, which the next server shows at once.
    for (const auto& entry : fs::directory_iterator(study + "/out"))
        EXPECT_EQ(entry.path().filename(), "report.html");
}

TEST_F(JsonOutput, OfADiagnosisAndItsChangesIsAsTheSchemasSay) {
    const std::string study = dry_study(effect_ + cell_and_rig_), out = study + "/out/";
    const std::string diagnosis = expect_output("diagnose " + study, "diagnosis");
    EXPECT_EQ(content_of(out + "diagnosis.json"), diagnosis);
    expect_output("diagnose " + study + " --confirm 0", "diagnosis");
    const std::string next = expect_output("next " + study, "next");
    EXPECT_EQ(content_of(out + "next.json"), next);
    EXPECT_THAT(next,
                testing::AllOf(HasSubstr("\"normal_force\""), HasSubstr("\"angular_velocity\"")));
    for (const char* change : {"add ", "drop "}) {
        expect_output(change + study + " lost-stress", "change");
        expect_valid(content_of(out + "fit.json"), "fit");
        expect_valid(content_of(out + "ladder.json"), "ladder");
    }
}

TEST_F(JsonOutput, OfASingleFileIsAsTheSchemaSays) {
    for (const char* const name : {"powder_cell_all.txt", "powder_cell.txt", "trios.csv",
                                   "rheocompass_fr.txt", "rheoplus.txt", "unit_row.csv"}) {
        const Outcome run = run_pendular(
            std::string("import " PENDULAR_SOURCE_DIR "/tests/data/formats/") + name + " --json -");
        EXPECT_TRUE(run.code == 0 || run.code == 2) << name;  // 2: nothing of it is used
        expect_valid(run.output, "import-file");
    }
}

/// A study that was calibrated, and what becomes of it when its files change.
class CalibratedStudy : public JsonOutput {
  protected:
    CalibratedStudy() : study_(dry_study("")) {
        expect_output("calibrate " + study_ + " --no-confirm", "fit");
    }
    nlohmann::ordered_json fit() const { return nlohmann::ordered_json::parse(content_of(file_)); }
    void write(const nlohmann::ordered_json& fit) const {
        folder_.write("out/fit.json", fit.dump());
    }

    const std::string study_;
    const std::string file_ = path("out/fit.json");
};

TEST_F(CalibratedStudy, OfAnotherFormatSaysWhatToDo) {
    auto other = fit();
    other["format"] = 3;
    write(other);
    expect_refused({"compare " + study_});
    other.erase("format");  // older than formats
    write(other);
    EXPECT_EQ(run_pendular("compare " + study_ + " --quiet").code, 0);
}

TEST_F(CalibratedStudy, OfFormatOneIsStillRead) {
    const std::string compared = run_pendular("compare " + study_ + " --quiet --json -").output;
    auto older = fit();
    auto& emulator = older["emulator"];
    emulator["scales"] = emulator["hyperparameters"];
    emulator.erase("hyperparameters");
    older["format"] = 1;
    write(older);
    EXPECT_EQ(run_pendular("compare " + study_ + " --quiet --json -").output, compared);
    ASSERT_EQ(run_pendular("add " + study_ + " dry-adhesion --quiet").code, 0);
    auto ladder = nlohmann::ordered_json::parse(content_of(path("out/ladder.json")));
    ladder["rungs"] = ladder["ladder_steps"];
    ladder.erase("ladder_steps");
    ladder["format"] = 1;
    folder_.write("out/ladder.json", ladder.dump());
    ASSERT_EQ(run_pendular("drop " + study_ + " dry-adhesion --quiet").code, 0);
    ladder = nlohmann::ordered_json::parse(content_of(path("out/ladder.json")));
    EXPECT_EQ(ladder["format"], 2);
    EXPECT_EQ(ladder["ladder_steps"].size(), 3u);
}

TEST_F(CalibratedStudy, RefusesALadderOfAnotherFormat) {
    folder_.write("out/ladder.json", "{\"format\": 3, \"ladder_steps\": []}");
    expect_refused({"add " + study_ + " dry-adhesion"});
}

TEST_F(CalibratedStudy, WhoseRunsAreGoneSaysWhatToDo) {
    auto other = fit();
    std::string names = other["runs"]["names"];
    other["runs"]["names"] = names.replace(3 * 17, 16, "0123456789abcdef");
    write(other);
    expect_refused({"compare " + study_});
}

}  // namespace app_schemas_test
