// Runs fuzz targets without a fuzzer: every input of a target's corpus, then inputs
// that are made from these by random changes, the same in every run.
//   fuzz_corpus TARGET CORPUS [EXECUTIONS [DICTIONARY]]
// Ends with exit code 1 where an input takes more than 10 s of the processor; what else is wrong
// with a target ends the program.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace {

namespace fs = std::filesystem;

constexpr double longest = 10;               ///< largest time for one input [s]
constexpr std::size_t most_bytes = 1 << 14;  ///< largest size of a changed input
constexpr int most_changes = 4;  ///< largest number of changes from an input of the corpus

std::vector<std::string> corpus_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> inputs;
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return inputs;
}

/// Words of a dictionary of libFuzzer: lines with a text in quotes, in which \xAB is a byte.
std::vector<std::string> words_in(const fs::path& file) {
    std::vector<std::string> words;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const std::size_t begin = line.find('"'), end = line.rfind('"');
        if (line.starts_with('#') || begin == std::string::npos || end <= begin) continue;
        std::string word;
        for (std::size_t k = begin + 1; k < end; ++k) {
            if (line[k] == '\\' && k + 3 < end && line[k + 1] == 'x') {
                word += static_cast<char>(std::stoi(line.substr(k + 2, 2), nullptr, 16));
                k += 3;
            } else if (line[k] != '\\' || line[++k] != '\0') {
                word += line[k];
            }
        }
        words.push_back(word);
    }
    return words;
}

/// Makes inputs from those of a corpus.
class Changes {
  public:
    Changes(const std::vector<std::string>& inputs, std::vector<std::string> words)
        : inputs_(inputs), words_(std::move(words)) {}

    std::string next() {
        std::string input = inputs_[below(inputs_.size())];
        for (std::size_t left = 1 + below(most_changes); left > 0; --left)
            change(input);
        if (input.size() > most_bytes) input.resize(most_bytes);
        return input;
    }

  private:
    std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

    void change(std::string& input) {
        const std::size_t at = below(input.size() + 1), count = below(input.size() - at + 1);
        switch (below(6)) {
            case 0:  // another byte
                if (at < input.size()) input[at] = static_cast<char>(below(256));
                break;
            case 1:  // a bit
                if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
                break;
            case 2:
                input.erase(at, count);
                break;
            case 3:  // a part once more
                input.insert(at, input.substr(at, count));
                break;
            case 4:
                if (!words_.empty()) input.insert(at, words_[below(words_.size())]);
                break;
            default: {  // a part of another input
                const std::string& other = inputs_[below(inputs_.size())];
                const std::size_t from = below(other.size() + 1);
                input.replace(at, count, other.substr(from, below(other.size() - from + 1)));
            }
        }
    }

    const std::vector<std::string>& inputs_;
    std::vector<std::string> words_;
    std::mt19937_64 random_{1};
};

/// Runs a target on an input. The input is kept in a file while the target runs, so that it is
/// there to look at if the target ends the program.
void run(const std::string& name, pendular::fuzz::Target target, const std::string& input) {
    std::ofstream(name + ".last", std::ios::binary) << input;
    const std::clock_t begin = std::clock();
    target(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (seconds > longest) {
        fmt::print(stderr, "{}: an input took {:.1f} s; it is in {}.last\n", name, seconds, name);
        std::exit(1);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> given(arguments + 1, arguments + count);
    const auto& targets = pendular::fuzz::targets();
    if (given.size() < 2 || !targets.contains(given[0])) {
        fmt::print(stderr, "usage: fuzz_corpus TARGET CORPUS [EXECUTIONS [DICTIONARY]]\n");
        return 2;
    }
    const auto target = targets.at(given[0]);
    const std::vector<std::string> inputs = corpus_in(given[1]);
    if (inputs.empty()) {
        fmt::print(stderr, "{} has no input\n", given[1]);
        return 1;
    }
    for (const std::string& input : inputs)
        run(given[0], target, input);
    const int executions = given.size() > 2 ? std::stoi(given[2]) : 0;
    Changes changes(inputs, given.size() > 3 ? words_in(given[3]) : std::vector<std::string>());
    for (int k = 0; k < executions; ++k)
        run(given[0], target, changes.next());
    fs::remove(given[0] + ".last");
    fs::remove_all(pendular::fuzz::folder());
    fmt::print("{}: {} inputs of the corpus and {} changed ones\n", given[0], inputs.size(),
               executions);
}
