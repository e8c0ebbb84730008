#include "sim/dem/pair_list.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/dem/bins.h"
#include "sim/dem/parts.h"

namespace pendular::dem {
namespace {

/// Affine strain after which the grains of a sample are renumbered [1]: rows one diameter apart
/// have then moved by one diameter against each other.
constexpr double strain_between_numberings = 1;

/// Periodic image of grain j nearest to grain i, in a sheared cell with a reduced offset
/// (Cell::reduce_offset).
Image nearest_image(const Grains& grains, const Cell& cell, std::size_t i, std::size_t j) {
    const Vector r = grains.position(j) - grains.position(i);
    const int n2 = -static_cast<int>(std::lround(r[1] / cell.height));
    return {-static_cast<int>(std::lround((r[0] + n2 * cell.offset) / cell.length)), n2,
            -static_cast<int>(std::lround(r[2] / cell.width))};
}

struct Neighbour {
    std::int32_t grain;
    std::uint8_t image;
};

/// Appends to `found` all grains with a number above i whose centre is within a range of grain i,
/// searching the bin of grain i and the 26 bins around. A bin beyond a face of the cell is the
/// image of a bin at the opposite face. `range_squared(j)` is the square of the range for grain j.
template <typename RangeSquared>
void neighbours_of(std::int32_t i, const Grains& grains, const Cell& cell, const Bins& bins,
                   const RangeSquared& range_squared, std::vector<Neighbour>& found) {
    const Vector& position = grains.position(static_cast<std::size_t>(i));
    const auto home = bins.bin_of(position);
    for (int step = 0; step < 27; ++step) {
        const std::array<int, 3> to = {home[0] + step % 3 - 1, home[1] + step / 3 % 3 - 1,
                                       home[2] + step / 9 - 1};
        const auto turn = [&](int d) { return to[d] < 0 ? -1 : to[d] >= bins.count(d) ? 1 : 0; };
        const Image image{turn(0), turn(1), turn(2)};
        const std::size_t bin =
            bins.index(to[0] - image.n1 * bins.count(0), to[1] - image.n2 * bins.count(1),
                       to[2] - image.n3 * bins.count(2));
        const Vector from = position - image.shift(cell);
        for (const auto* j = bins.begin(bin); j != bins.end(bin); ++j) {
            const Vector r = j->position - from;
            if (j->grain > i && dot(r, r) < range_squared(j->grain)) {
                found.push_back({j->grain, static_cast<std::uint8_t>(image_code::of(image))});
            }
        }
    }
}

/// Largest squared length among these vectors.
double largest_squared(const std::vector<Vector>& vectors) {
    double longest = 0;
    for (const Vector& v : vectors) {
        longest = std::max(longest, dot(v, v));
    }
    return longest;
}

/// Whether two grains that were further apart than `left_out` when a list was made may now be
/// closer than `within`, given the largest displacement of a grain and the affine strain since
/// then (criterion of `PairList`).
bool outdated(double displacement, double strain, double left_out, double within) {
    const double g = strain + strain * strain;
    return (left_out - 2 * displacement * (1 + g)) * (1 - g) <= within;
}

/// Finds pairs in a sorted list, for searches in ascending order.
class Cursor {
  public:
    Cursor(const Pairs& pairs, std::size_t live) : pairs_(pairs), live_(live) {}

    /// Index of the pair (i, j) in the list; `live` where the list lacks it. Successive calls must
    /// be in ascending order of (i, j).
    std::size_t find(std::int32_t i, std::int32_t j) {
        while (at_ < live_ &&
               (pairs_.first[at_] < i || (pairs_.first[at_] == i && pairs_.second[at_] < j))) {
            ++at_;
        }
        return at_ < live_ && pairs_.first[at_] == i && pairs_.second[at_] == j ? at_ : live_;
    }

  private:
    const Pairs& pairs_;
    std::size_t live_, at_ = 0;
};

template <typename Value>
void permute(std::vector<Value>& values, const std::vector<std::int32_t>& order) {
    std::vector<Value> permuted;
    permuted.reserve(values.size());
    for (const std::int32_t i : order) {
        permuted.push_back(values[static_cast<std::size_t>(i)]);
    }
    values = std::move(permuted);
}

/// Returns the first `live` pairs of a list with new grain numbers, sorted again. `renamed` has the
/// new number of each grain.
Pairs renumbered(const Pairs& pairs, std::size_t live, const std::vector<std::int32_t>& renamed) {
    const auto name = [&](std::int32_t i) { return renamed[static_cast<std::size_t>(i)]; };
    std::vector<std::size_t> order(live);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) {
        return std::minmax({name(pairs.first[k]), name(pairs.second[k])});
    });
    Pairs result({}, pairs.contact_history.size());
    result.reserve(live);
    for (const std::size_t k : order) {
        const std::int32_t i = name(pairs.first[k]), j = name(pairs.second[k]);
        result.add(std::min(i, j), std::max(i, j), pairs.image[k]);
        result.remember(result.size() - 1, pairs, k);
        if (i > j) {  // the grains swap, which reverses the separation
            const Image n = image_code::image(pairs.image[k]);
            result.image.back() = static_cast<std::uint8_t>(image_code::of({-n.n1, -n.n2, -n.n3}));
            for (auto* component : {&result.sx, &result.sy, &result.sz}) {
                component->back() = -component->back();
            }
            for (auto& word : result.contact_history) {
                word.back() = -word.back();
            }
        }
    }
    return result;
}

}  // namespace

void Neighbours::add(std::int32_t i, std::int32_t j, std::uint8_t code) {
    first.push_back(i), second.push_back(j), image.push_back(code);
}

void Neighbours::append(const Neighbours& others) {
    first.insert(first.end(), others.first.begin(), others.first.end());
    second.insert(second.end(), others.second.begin(), others.second.end());
    image.insert(image.end(), others.image.begin(), others.image.end());
}

void Neighbours::reserve(std::size_t count) {
    first.reserve(count), second.reserve(count), image.reserve(count);
}

Pairs::Pairs(Neighbours neighbours, std::size_t words)
    : Neighbours(std::move(neighbours)), contact_history(words) {
    for (auto* column : {&sx, &sy, &sz, &root, &bridge}) {
        column->assign(size(), 0.0);
    }
    for (auto& word : contact_history) {
        word.assign(size(), 0.0);
    }
}

void Pairs::clear() {
    first.clear(), second.clear(), image.clear();
    sx.clear(), sy.clear(), sz.clear(), root.clear(), bridge.clear();
    for (auto& word : contact_history) {
        word.clear();
    }
}

void Pairs::reserve(std::size_t count) {
    Neighbours::reserve(count);
    for (auto* column : {&sx, &sy, &sz, &root, &bridge}) {
        column->reserve(count);
    }
}

void Pairs::add(std::int32_t i, std::int32_t j, std::uint8_t code) {
    Neighbours::add(i, j, code);
    sx.push_back(0), sy.push_back(0), sz.push_back(0), root.push_back(0), bridge.push_back(0);
    for (auto& word : contact_history) {
        word.push_back(0);
    }
}

void Pairs::fill_up(std::size_t batch) {
    while (size() % batch != 0) {
        add(0, 0, image_code::nowhere);
    }
}

void Pairs::remember(std::size_t to, const Pairs& other, std::size_t from) {
    sx[to] = other.sx[from], sy[to] = other.sy[from], sz[to] = other.sz[from];
    root[to] = other.root[from], bridge[to] = other.bridge[from];
    remember_effects(to, other, from);
}

void Pairs::remember_effects(std::size_t to, const Pairs& other, std::size_t from) {
    for (std::size_t w = 0; w < contact_history.size(); ++w) {
        contact_history[w][to] = other.contact_history[w][from];
    }
}

std::vector<double> Pairs::history_of(std::size_t k) const {
    std::vector<double> values;
    for (const std::vector<double>& all : contact_history) {
        values.push_back(all[k]);
    }
    return values;
}

Neighbours find_pairs_by_brute_force(const Grains& grains, const Cell& cell, double gap) {
    Neighbours pairs;
    for (std::size_t i = 0; i < grains.size(); ++i) {
        for (std::size_t j = i + 1; j < grains.size(); ++j) {
            const Image image = nearest_image(grains, cell, i, j);
            const Vector r = grains.position(j) - grains.position(i) + image.shift(cell);
            const double range = grains.contact_distance(i, j) + gap;
            if (dot(r, r) < range * range) {
                pairs.add(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                          static_cast<std::uint8_t>(image_code::of(image)));
            }
        }
    }
    return pairs;
}

Neighbours find_pairs(const Grains& grains, const Cell& cell, double gap, int parts) {
    const Bins bins(grains, cell, grains.largest_diameter() + gap);
    if (!bins.enough()) {
        return find_pairs_by_brute_force(grains, cell, gap);
    }
    const double equal = (1 + gap) * (1 + gap);
    std::vector<Neighbours> found(static_cast<std::size_t>(parts));
    in_parts(parts, [&](int part) {
        Neighbours& mine = found[static_cast<std::size_t>(part)];
        const auto [begin, end] = range_of(part, parts, grains.size());
        mine.reserve((end - begin) * 5);
        std::vector<Neighbour> around;
        for (auto i = static_cast<std::int32_t>(begin); i < static_cast<std::int32_t>(end); ++i) {
            around.clear();
            if (grains.diameters.empty()) {
                neighbours_of(
                    i, grains, cell, bins, [&](std::int32_t) { return equal; }, around);
            } else {
                const auto squared = [&](std::int32_t j) {
                    const double range = grains.contact_distance(static_cast<std::size_t>(i),
                                                                 static_cast<std::size_t>(j)) +
                                         gap;
                    return range * range;
                };
                neighbours_of(i, grains, cell, bins, squared, around);
            }
            std::ranges::sort(around, {}, &Neighbour::grain);
            for (const auto& neighbour : around) {
                mine.add(i, neighbour.grain, neighbour.image);
            }
        }
    });
    for (std::size_t part = 1; part < found.size(); ++part) {
        found.front().append(found[part]);
    }
    return std::move(found.front());
}

PairList::PairList(double rupture_distance, int parts, const ListRequirements& requirements)
    : wide_skin_(std::max(shortest_wide_skin, rupture_distance)),
      parts_(parts),
      requirements_(requirements),
      narrow_({}, requirements.contact_history),
      distant_({}, requirements.contact_history),
      old_narrow_({}, requirements.contact_history),
      old_distant_({}, requirements.contact_history) {
    if (requirements.all_in_reach) {
        // Half a skin more than must be known, or each renewal of the narrow list would search the
        // bins again.
        reach_ = std::max(reach_, rupture_distance);
        wide_skin_ = std::max(wide_skin_, reach_ + narrow_skin + shortest_wide_skin / 2);
    }
}

void PairList::update(Grains& grains, Cell& cell, double affine_strain) {
    update(grains, cell, affine_strain, largest_squared(grains.displacement));
}

void PairList::update(Grains& grains, Cell& cell, double affine_strain, double squared) {
    narrow_strain_ += affine_strain;
    if (!outdated(std::sqrt(squared), narrow_strain_, largest_ + narrow_skin, largest_)) {
        return;
    }
    wide_strain_ += narrow_strain_;
    strain_since_renumbered_ += narrow_strain_;
    for (std::size_t i = 0; i < grains.size(); ++i) {
        moved_[i] += grains.displacement[i];
    }
    // The wide list must hold every pair that the other lists need. Until these are selected again,
    // grains come closer by less than the narrow skin.
    const double known =
        requirements_.all_in_reach ? largest_ + reach_ + narrow_skin : largest_ + narrow_skin;
    if (outdated(std::sqrt(largest_squared(moved_)), wide_strain_, largest_ + wide_skin_, known)) {
        rebuild(grains, cell);
    } else {
        select(grains, cell);
    }
}

void PairList::rebuild(Grains& grains, Cell& cell) {
    cell.reduce_offset();
    for (auto& grain : grains.motion) {
        grain.position = cell.wrapped(grain.position);
    }
    if (strain_since_renumbered_ > strain_between_numberings) {
        renumber(grains, cell);
    }
    wide_ = {};  // frees the memory before the search allocates more
    largest_ = grains.largest_diameter();
    wide_ = find_pairs(grains, cell, wide_skin_, parts_);
    moved_.assign(grains.size(), Vector());
    wide_strain_ = 0;
    ++wide_rebuilds_;
    select(grains, cell);
}

void PairList::renumber(Grains& grains, const Cell& cell) {
    const auto order = order_in_rows(grains, cell);
    permute(grains.motion, order);
    permute(grains.number, order);
    if (!grains.diameters.empty()) {
        permute(grains.diameters, order);
    }
    std::vector<std::int32_t> renamed(order.size());
    for (std::size_t to = 0; to < order.size(); ++to) {
        renamed[static_cast<std::size_t>(order[to])] = static_cast<std::int32_t>(to);
    }
    narrow_ = renumbered(narrow_, live_, renamed);
    distant_ = renumbered(distant_, live_distant_, renamed);
    strain_since_renumbered_ = 0;
}

void PairList::find_close_ones(const Grains& grains, const Cell& cell) {
    std::array<Vector, image_code::count> shifts;
    for (int code = 0; code < image_code::count; ++code) {
        shifts[static_cast<std::size_t>(code)] = image_code::image(code).shift(cell);
    }
    const double equal = (1 + narrow_skin) * (1 + narrow_skin);
    const bool sized = !grains.diameters.empty();
    close_.resize(wide_.size());
    in_parts(parts_, [&](int part) {
        const auto [begin, end] = range_of(part, parts_, wide_.size());
        for (std::size_t k = begin; k < end; ++k) {
            const auto i = static_cast<std::size_t>(wide_.first[k]),
                       j = static_cast<std::size_t>(wide_.second[k]);
            const Vector r =
                grains.motion[j].position - grains.motion[i].position + shifts[wide_.image[k]];
            const double range = sized ? grains.contact_distance(i, j) + narrow_skin : 0;
            close_[k] = dot(r, r) < (sized ? range * range : equal);
        }
    });
}

void PairList::select(Grains& grains, const Cell& cell) {
    find_close_ones(grains, cell);
    std::swap(narrow_, old_narrow_);
    std::swap(distant_, old_distant_);
    Cursor old_narrow(old_narrow_, live_), old_distant(old_distant_, live_distant_);
    const std::size_t none = live_, none_distant = live_distant_;
    narrow_.clear();
    distant_.clear();
    for (std::size_t k = 0; k < wide_.size(); ++k) {
        const std::int32_t i = wide_.first[k], j = wide_.second[k];
        const std::size_t near = old_narrow.find(i, j), far = old_distant.find(i, j);
        const bool joined = near != none ? old_narrow_.bridge[near] > 0
                                         : far != none_distant && old_distant_.bridge[far] > 0;
        if (close_[k]) {
            narrow_.add(i, j, wide_.image[k]);
            if (near != none) {
                narrow_.remember(narrow_.size() - 1, old_narrow_, near);
            }
            // Without contact a pair has no tangential spring: only what effects keep goes on.
            if (near == none && far != none_distant) {
                narrow_.remember_effects(narrow_.size() - 1, old_distant_, far);
            }
            narrow_.bridge.back() = joined;
        } else if (joined || requirements_.all_in_reach) {
            distant_.add(i, j, wide_.image[k]);
            if (near != none) {
                distant_.remember_effects(distant_.size() - 1, old_narrow_, near);
            } else if (far != none_distant) {
                distant_.remember_effects(distant_.size() - 1, old_distant_, far);
            }
            distant_.bridge.back() = joined;
        }
    }
    live_ = narrow_.size();
    live_distant_ = distant_.size();
    narrow_.fill_up(batch);
    distant_.fill_up(batch);
    grains.displacement.assign(grains.size(), Vector());
    narrow_strain_ = 0;
    ++renewals_;
}

}  // namespace pendular::dem
