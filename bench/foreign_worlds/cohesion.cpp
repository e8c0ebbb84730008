// LAMMPS with a force of attraction between grains of diameter 1, which its Debian package lacks:
// liquid bridges with a hysteresis. Everything else, contacts, integration and height control, is
// LAMMPS'. Written apart from Pendular's code.
//
//     c++ -O3 -std=c++20 $(pkg-config --cflags mpi-cxx) cohesion.cpp -llammps -lmpi -o cohesion
//     cohesion LAW FORCE VOLUME FOLDER -var ...      (variables of the folder's sample.lmp and
//                                                    flow.lmp)
//
// LAW: contact     FORCE while two grains touch
//      capillary   a bridge forms on contact, breaks at the gap D0 = VOLUME^(1/3); force at the gap
//      h
//                  FORCE (1 - h/sqrt(h^2 + 4 VOLUME/pi)), FORCE on contact (Maugis)
//      reversible  the same force wherever h < D0
//      constant    a bridge forms on contact, breaks at D0; force FORCE
#include <lammps/library.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unordered_set>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double skin = 0.2;

struct Box {
    std::array<double, 3> edge{};
    std::array<int, 3> periodic{};
    double tilt = 0;
    /// From one centre to the nearest image of another.
    std::array<double, 3> nearest(const double* from, const double* to) const {
        std::array<double, 3> d = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        const double layers = images(d, 1);
        d[1] -= layers * edge[1];
        d[0] -= layers * tilt;
        d[0] -= images(d, 0) * edge[0];
        d[2] -= images(d, 2) * edge[2];
        return d;
    }
    double images(const std::array<double, 3>& d, int k) const {
        return periodic[k] ? std::rint(d[k] / edge[k]) : 0;
    }
};

struct Pair {
    int i, j;  ///< numbers of grains, from 0
    bool joined;
};

class Cohesion {
  public:
    Cohesion(void* lammps, const std::string& law, double force, double volume)
        : lammps_(lammps),
          hysteretic_(law == "capillary" || law == "constant"),
          constant_(law == "contact" || law == "constant"),
          force_(force),
          range_(law == "contact" ? 0 : std::cbrt(volume)),
          c_(4 * volume / pi) {}

    void act(int grains, const int* tags, double** x, double** f) {
        Box box;
        double low[3], high[3], xz, yz;
        int change;
        lammps_extract_box(lammps_, low, high, &box.tilt, &yz, &xz, box.periodic.data(), &change);
        for (int d = 0; d < 3; ++d) {
            box.edge[d] = high[d] - low[d];
        }
        at_.resize(grains), forces_.resize(grains), free_.resize(grains);
        const auto* types = static_cast<const int*>(lammps_extract_atom(lammps_, "type"));
        for (int k = 0; k < grains; ++k) {
            free_[tags[k] - 1] = types[k] == 1;
            at_[tags[k] - 1] = x[k];
            forces_[tags[k] - 1] = f[k];
            f[k][0] = f[k][1] = f[k][2] = 0;
        }
        // Where a flow begins, grains still rest while the images above them already move.
        const double sheared = std::remainder(box.tilt - listed_tilt_, box.edge[0]);
        if (steps_left_-- <= 0 || std::abs(sheared) > skin / 4) list_pairs(box, grains);
        std::array<double, 6> virial{};
        double joined = 0;  // half of a bridge is a free grain's, half a glued one's
        for (Pair& pair : pairs_) {
            if (pull(pair, box, virial)) joined += 0.5 * (free_[pair.i] + free_[pair.j]);
        }
        lammps_fix_external_set_virial_global(lammps_, "bridges", virial.data());
        lammps_fix_external_set_vector(lammps_, "bridges", 1, joined);
    }

  private:
    bool pull(Pair& pair, const Box& box, std::array<double, 6>& virial) {
        const auto d = box.nearest(at_[pair.i], at_[pair.j]);
        const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        const bool near = squared < (1 + range_) * (1 + range_);
        pair.joined = near && (!hysteretic_ || pair.joined || squared < 1);
        if (!pair.joined) return false;
        const double distance = std::sqrt(squared), gap = distance - 1;
        const double pull =
            gap < 0 || constant_ ? force_ : force_ * (1 - gap / std::sqrt(gap * gap + c_));
        std::array<double, 3> on_first{};
        for (int k = 0; k < 3; ++k) {
            on_first[k] = pull * d[k] / distance;
            forces_[pair.i][k] += on_first[k];
            forces_[pair.j][k] -= on_first[k];
        }
        for (int k = 0; k < 3; ++k) {
            virial[k] -= d[k] * on_first[k];
        }
        virial[3] -= d[0] * on_first[1];
        virial[4] -= d[0] * on_first[2];
        virial[5] -= d[1] * on_first[2];
        return true;
    }

    /// All pairs closer than the range and the skin, by a sweep along the gradient. Stays valid for
    /// as many steps as half the skin takes at the present speeds; ends the program where a pair
    /// within reach had been missed.
    void list_pairs(const Box& box, int grains) {
        std::unordered_set<std::int64_t> old_pairs, old_joined;
        const auto key = [&](int i, int j) {
            return static_cast<std::int64_t>(std::min(i, j)) * grains + std::max(i, j);
        };
        for (const Pair& pair : pairs_) {
            old_pairs.insert(key(pair.i, pair.j));
            if (pair.joined) old_joined.insert(key(pair.i, pair.j));
        }
        const double reach = 1 + range_ + skin;
        std::vector<int> order(grains);
        std::vector<double> height(grains);
        for (int k = 0; k < grains; ++k) {
            order[k] = k;
            height[k] = at_[k][1];
            if (box.periodic[1]) height[k] -= std::floor(at_[k][1] / box.edge[1]) * box.edge[1];
        }
        std::sort(order.begin(), order.end(), [&](int a, int b) { return height[a] < height[b]; });
        const bool first = !listed_;
        listed_ = true;
        listed_tilt_ = box.tilt;
        pairs_.clear();
        for (int a = 0; a < grains; ++a) {
            for (int step = 1; step < grains; ++step) {
                const int b = a + step, i = order[a], j = order[b % grains];
                if (b >= grains && !box.periodic[1]) break;
                const double above = height[j] + (b >= grains ? box.edge[1] : 0) - height[i];
                if (above > reach) break;
                const auto d = box.nearest(at_[i], at_[j]);
                const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                if (squared > reach * reach) continue;
                if (!first && !old_pairs.contains(key(i, j)) &&
                    squared < (1 + range_) * (1 + range_)) {
                    std::fprintf(stderr, "cohesion: a pair was missed\n");
                    std::exit(1);
                }
                pairs_.push_back({i, j, old_joined.contains(key(i, j))});
            }
        }
        steps_left_ = steps_valid(grains);
    }

    /// Steps until two grains may have come nearer by half the skin; few, since a flow that begins
    /// soon moves faster than at present.
    int steps_valid(int grains) const {
        const double dt = *static_cast<double*>(lammps_extract_global(lammps_, "dt"));
        auto** v = static_cast<double**>(lammps_extract_atom(lammps_, "v"));
        auto** x = static_cast<double**>(lammps_extract_atom(lammps_, "x"));
        // Speed about the mean flow, whose gradient is fitted.
        double xy = 0, yy = 0, y_mean = 0, v_mean = 0;
        for (int k = 0; k < grains; ++k) {
            y_mean += x[k][1] / grains, v_mean += v[k][0] / grains;
        }
        for (int k = 0; k < grains; ++k) {
            xy += (x[k][1] - y_mean) * (v[k][0] - v_mean);
            yy += (x[k][1] - y_mean) * (x[k][1] - y_mean);
        }
        const double rate = xy / yy;
        double fastest = 0;
        for (int k = 0; k < grains; ++k) {
            const double along = v[k][0] - v_mean - rate * (x[k][1] - y_mean);
            fastest = std::max(fastest, std::hypot(along, v[k][1], v[k][2]));
        }
        const double approach = 2 * fastest + 1.5 * std::abs(rate) + 0.05;
        return static_cast<int>(std::clamp(0.5 * skin / (approach * dt), 1.0, 25.0));
    }

    void* lammps_;
    bool hysteretic_;  ///< a bridge forms on contact
    bool constant_;    ///< the force does not depend on the gap
    double force_, range_, c_;
    std::vector<double*> at_, forces_;
    std::vector<char> free_;  ///< of type 1: the other types are glued
    std::vector<Pair> pairs_;
    bool listed_ = false;
    double listed_tilt_ = 0;
    int steps_left_ = 0;
};

void call(void* cohesion, std::int64_t, int grains, int* tags, double** x, double** f) {
    static_cast<Cohesion*>(cohesion)->act(grains, tags, x, f);
}

}  // namespace

int main(int count, char** words) {
    if (count < 5) {
        std::fprintf(stderr, "usage: cohesion LAW FORCE VOLUME FOLDER -var ...\n");
        return 2;
    }
    const std::string law = words[1], folder = words[4];
    std::vector<char*> for_lammps = {words[0]};
    std::string fixed[] = {"-log", "none"};
    for (std::string& word : fixed) {
        for_lammps.push_back(word.data());
    }
    for_lammps.insert(for_lammps.end(), words + 5, words + count);
    void* lammps =
        lammps_open_no_mpi(static_cast<int>(for_lammps.size()), for_lammps.data(), nullptr);
    Cohesion cohesion(lammps, law, std::atof(words[2]), std::atof(words[3]));
    lammps_file(lammps, (folder + "/sample.lmp").c_str());
    lammps_command(lammps, "fix bridges all external pf/callback 1 1");
    lammps_set_fix_external_callback(lammps, "bridges", call, &cohesion);
    lammps_fix_external_set_vector_length(lammps, "bridges", 1);
    lammps_file(lammps, (folder + "/flow.lmp").c_str());
    lammps_close(lammps);
    lammps_mpi_finalize();
    return 0;
}
