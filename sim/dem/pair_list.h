#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Pairs of neighbouring grains, sorted by the first and then by the second index; `first` is the
/// smaller one. The separation of a pair points from the centre of the first grain to the centre of
/// a periodic image (`image`) of the second.
struct Neighbours {
    std::vector<std::int32_t> first, second;
    std::vector<std::uint8_t> image;  ///< `image_code` of the second grain

    std::size_t size() const { return first.size(); }
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    void append(const Neighbours& others);
    void reserve(std::size_t count);

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(first, second, image);
    }
};

/// Pairs of grains with their contact history, which is kept from one time step to the next. Each
/// quantity is an array with one element for each pair.
struct Pairs : Neighbours {
    /// Tangential force on the second grain, over a^2 s22 (a: grain diameter, s22: imposed normal
    /// stress).
    std::vector<double> sx, sy, sz;
    std::vector<double> root;    ///< square root of overlap over diameter; 0 without contact
    std::vector<double> bridge;  ///< 1 if a bridge joins the grains, else 0
    /// Values that effects keep for each pair: contact_history[v][k] is value v of pair k.
    std::vector<std::vector<double>> contact_history;

    Pairs() = default;
    explicit Pairs(Neighbours neighbours, std::size_t words = 0);
    void clear();
    void reserve(std::size_t count);
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    /// Adds placeholder pairs up to a multiple of `batch`.
    void fill_up(std::size_t batch);
    /// Copies the contact history of pair `from` in the list `other` to pair `to` in this list.
    void remember(std::size_t to, const Pairs& other, std::size_t from);
    /// Copies only the values that effects keep, such as the volume of a bridge, for a pair that
    /// changes between the narrow and the distant list: it has no contact to be remembered.
    void remember_effects(std::size_t to, const Pairs& other, std::size_t from);
    /// Returns the values that effects keep for pair number `k`.
    std::vector<double> history_of(std::size_t k) const;

    template <typename Archive>
    void serialize(Archive& archive) {
        Neighbours::serialize(archive);
        archive(sx, sy, sz, root, bridge, contact_history);
    }
};

/// Data that the effects of a run need in the neighbour lists.
struct ListRequirements {
    std::size_t contact_history = 0;  ///< values that effects keep for each pair
    /// Whether the distant list must contain all pairs that a bridge could join, not only those
    /// that one joins: true if bridges can form between grains that do not touch.
    bool all_in_reach = false;
};

/// Neighbour lists of a sample. The wide list contains all pairs whose grains may come close or be
/// joined by a bridge; the narrow list those of them whose grains touch or may touch soon; the
/// distant list the remaining ones that a bridge joins or, with `ListRequirements::all_in_reach`,
/// all remaining ones.
///
/// Only the wide list is searched in bins; it stays valid for long, and the other two are selected
/// from it, so that the force loop visits few pairs in vain. Pairs that only a bridge joins have a
/// loop of their own without contact law (`distant_forces`). Only pairs of the narrow and the
/// distant list keep a contact history.
///
/// When the wide or the narrow list is made, it contains all pairs whose gap is smaller than a
/// length, the skin of the list. Two grains whose centres were further apart than D + skin at that
/// time stay further apart than a distance d while
///     (D + skin - 2 u (1 + g)) (1 - g) > d,   g = e + e^2
/// D is the largest grain diameter, and u the largest displacement of a grain without the imposed
/// flow since the list was made. The strain e is the affine strain (shear plus changes of the
/// cell's edges) since the list was made. The criterion includes the affine strain because the
/// offset of the periodic images moves even where no grain does. The wide skin is at least the
/// rupture distance, so that the list holds every pair that a bridge joins.
class PairList {
  public:
    /// Number of pairs for which the forces are computed at once. Placeholder pairs, whose grains
    /// never touch, fill the narrow and the distant list up to whole batches.
    static constexpr std::size_t batch = 64;
    /// Skins [grain diameters]. Chosen between two costs: a list with a thin skin is renewed more
    /// often, one with a thick skin has more pairs that do not interact. No result depends on them.
    static constexpr double shortest_wide_skin = 0.2;
    static constexpr double narrow_skin = 0.02;

    /// Makes empty lists.
    /// @param rupture_distance gap at which bridges break [grain diameters], 0 without bridges
    /// @param parts number of threads that renew the lists, on which the lists do not depend
    explicit PairList(double rupture_distance = 0, int parts = 1,
                      const ListRequirements& requirements = {});

    /// Renews each list that may no longer contain all close pairs after a time step. When the wide
    /// list is renewed, the grains are moved into the cell by whole lattice vectors and may be
    /// renumbered.
    /// @param affine_strain of the step [1]: shear plus changes of the cell's edges
    void update(Grains& grains, Cell& cell, double affine_strain);
    /// Renews the lists like the other overload, but with a known largest displacement of a grain.
    /// @param largest_squared squared displacement, without the imposed flow, since the narrow list
    ///         was made [squared grain diameters]
    void update(Grains& grains, Cell& cell, double affine_strain, double largest_squared);

    /// Renews all three lists, even if they are still valid, and keeps the contact history. Grains
    /// are moved into the cell, and renumbered if shear has mixed them.
    void rebuild(Grains& grains, Cell& cell);

    Pairs& narrow() { return narrow_; }
    const Pairs& narrow() const { return narrow_; }
    /// Returns the number of real pairs in the narrow list, which precede the placeholder pairs.
    std::size_t live() const { return live_; }
    /// Returns the distant list. It is renewed before any of its pairs comes into contact.
    Pairs& distant() { return distant_; }
    const Pairs& distant() const { return distant_; }
    std::size_t live_distant() const { return live_distant_; }
    std::size_t wide_rebuilds() const { return wide_rebuilds_; }
    /// Returns how many times the narrow and the distant list were renewed, always together.
    std::size_t renewals() const { return renewals_; }

    /// Saves or loads the lists; the loading object must have been constructed with the rupture
    /// distance and the `ListRequirements` of the saved one.
    template <typename Archive>
    void serialize(Archive& archive) {
        archive(wide_, narrow_, distant_, live_, live_distant_, moved_, wide_strain_,
                narrow_strain_, strain_since_renumbered_, wide_rebuilds_);
    }

  private:
    void renumber(Grains& grains, const Cell& cell);
    void select(Grains& grains, const Cell& cell);
    void find_close_ones(const Grains& grains, const Cell& cell);

    double wide_skin_;
    /// Gap [grain diameters] below which the wide list must contain all pairs, if all in reach are
    /// needed.
    double reach_ = narrow_skin;
    int parts_;
    ListRequirements requirements_;
    double largest_ = 1;  ///< largest diameter in the sample over the mean diameter
    Neighbours wide_;
    Pairs narrow_, distant_;
    std::size_t live_ = 0, live_distant_ = 0;
    /// Displacement of each grain, without the imposed flow, from the making of the wide list to
    /// that of the narrow list [grain diameters].
    std::vector<Vector> moved_;
    double wide_strain_ = 0, narrow_strain_ = 0, strain_since_renumbered_ = 1e9;
    std::size_t wide_rebuilds_ = 0, renewals_ = 0;
    // Buffers that are members only to reuse their memory.
    std::vector<std::uint8_t> close_;
    Pairs old_narrow_, old_distant_;
};

/// Returns all pairs of grains, periodic images included, whose surfaces are closer than `gap`
/// [grain diameters]. All centres must be inside the cell. The search uses bins that are sheared
/// with the lattice; in a sample that is too small for bins, all pairs are tested.
/// @param parts number of threads, on which the result does not depend
Neighbours find_pairs(const Grains& grains, const Cell& cell, double gap, int parts = 1);

/// Returns what `find_pairs` returns by testing every pair: slow, for small samples and tests.
Neighbours find_pairs_by_brute_force(const Grains& grains, const Cell& cell, double gap);

}  // namespace pendular::dem
