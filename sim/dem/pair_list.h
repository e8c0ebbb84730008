#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// List of pairs of neighbouring grains. The array `first` contains the smaller of the two grain
/// indices of each pair. Pairs are sorted by the first and then by the second index. The separation
/// of a pair points from the centre of the first grain to the centre of a periodic image (`image`)
/// of the second grain.
struct Neighbours {
    std::vector<std::int32_t> first, second;
    /// Code of the periodic image (`image_code`) of the second grain of each pair.
    std::vector<std::uint8_t> image;

    std::size_t size() const { return first.size(); }
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    void append(const Neighbours& others);
    void reserve(std::size_t count);

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(first, second, image);
    }
};

/// Pairs of grains with their contact history (values that are kept from one time step to the
/// next). Each quantity is an array with one element for each pair.
struct Pairs : Neighbours {
    /// Components of the tangential force on the second grain of each pair, in units of a^2 s22,
    /// with grain diameter a and imposed normal stress s22.
    std::vector<double> sx, sy, sz;
    /// Square root of (overlap divided by grain diameter) of each pair in the last time step [1].
    /// The root is 0 without contact.
    std::vector<double> root;
    /// State of the liquid bridge of each pair of grains: 1 if a bridge joins the grains, else 0.
    std::vector<double> bridge;
    /// Values that physical effects store for each pair from one time step to the next, such as a
    /// tangential displacement. The element contact_history[v][k] is value v of pair k.
    std::vector<std::vector<double>> contact_history;

    Pairs() = default;
    explicit Pairs(Neighbours neighbours, std::size_t words = 0);
    void clear();
    void reserve(std::size_t count);
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    /// Adds placeholder pairs, whose grains never touch, until the number of pairs is a multiple of
    /// `batch`.
    void fill_up(std::size_t batch);
    /// Copies the contact history of a pair from the list `other` to this list. The contact history
    /// consists of the tangential force, the overlap, the state of the bridge and the values that
    /// physical effects store.
    /// @param to index of the pair in this list
    /// @param from index of the pair in the list `other`
    void remember(std::size_t to, const Pairs& other, std::size_t from);
    /// Copies the values that physical effects store for a pair, such as the volume of its bridge,
    /// from the list `other` to this list.
    /// @param to index of the pair in this list
    /// @param from index of the pair in the list `other`
    void remember_effects(std::size_t to, const Pairs& other, std::size_t from);
    /// Returns the values that physical effects store for pair number `k`, counted from 0, such as
    /// the volume of the pair's bridge.
    std::vector<double> history_of(std::size_t k) const;

    template <typename Archive>
    void serialize(Archive& archive) {
        Neighbours::serialize(archive);
        archive(sx, sy, sz, root, bridge, contact_history);
    }
};

/// Data that the physical effects of a run need in the neighbour lists (`PairList`).
struct ListRequirements {
    std::size_t contact_history = 0;  ///< number of values that effects store for each pair
    /// Whether the distant neighbour list (pairs of grains that do not touch) must contain all
    /// pairs that a liquid bridge could join, rather than only the pairs that a bridge joins. The
    /// member must be true if bridges can form between grains that do not touch.
    bool all_in_reach = false;
};

/// Neighbour lists of a sample. The wide list contains all pairs whose grains may come close or be
/// joined by a bridge. The narrow list contains the pairs of the wide list whose grains touch or
/// may touch soon. The distant list contains the remaining pairs of the wide list that a bridge
/// joins. If `ListRequirements::all_in_reach` is true, the distant list contains all remaining
/// pairs.
///
/// When the wide or the narrow list is made, the list contains all pairs whose gap is smaller than
/// a length, the skin of the list. Two grains whose centres were further apart than D + skin at
/// that time stay further apart than a distance d while
///     (D + skin - 2 u (1 + g)) (1 - g) > d,   g = e + e^2
/// D is the largest grain diameter, and u the largest displacement of a grain without the imposed
/// flow since the list was made. The strain e is the affine strain (shear plus changes of the
/// cell's edges) since the list was made.
class PairList {
  public:
    /// Number of pairs in a batch, for which the forces are computed at once. Placeholder pairs,
    /// whose grains never touch, fill the narrow and the distant list up to whole batches.
    static constexpr std::size_t batch = 64;
    static constexpr double shortest_wide_skin = 0.2;
    static constexpr double narrow_skin = 0.02;

    /// Makes empty neighbour lists.
    /// @param rupture_distance gap at which liquid bridges break [grain diameters], 0 without
    ///         bridges
    /// @param parts number of threads that renew the lists; the lists do not depend on this number
    /// @param requirements data that the physical effects of the run need in the lists
    explicit PairList(double rupture_distance = 0, int parts = 1,
                      const ListRequirements& requirements = {});

    /// Renews each neighbour list that may no longer contain all close pairs after a time step.
    /// When the wide list is renewed, the grains are moved into the cell by whole lattice vectors
    /// and may be renumbered.
    /// @param affine_strain strain of the cell in the step [1]: shear plus changes of the cell's
    ///         edges
    void update(Grains& grains, Cell& cell, double affine_strain);
    /// Renews each neighbour list that may no longer contain all close pairs after a time step. The
    /// caller states the largest displacement of a grain.
    /// @param affine_strain strain of the cell in the step [1]: shear plus changes of the cell's
    ///         edges
    /// @param largest_squared largest squared displacement of a grain, without the imposed flow,
    ///         since the narrow list was made [squared grain diameters]
    void update(Grains& grains, Cell& cell, double affine_strain, double largest_squared);

    /// Renews the wide, the narrow and the distant neighbour list, even if all three are still
    /// valid, and keeps the contact history of the pairs. Grains are moved into the cell by whole
    /// lattice vectors. Grains are renumbered if shear has mixed them.
    void rebuild(Grains& grains, Cell& cell);

    Pairs& narrow() { return narrow_; }
    const Pairs& narrow() const { return narrow_; }
    /// Returns the number of real pairs in the narrow neighbour list. The real pairs precede the
    /// placeholder pairs, which fill up the last batch.
    std::size_t live() const { return live_; }
    /// Returns the distant list: pairs of grains that did not touch when the list was made and that
    /// a bridge joined or could join. The list is renewed before any of its pairs comes into
    /// contact.
    Pairs& distant() { return distant_; }
    const Pairs& distant() const { return distant_; }
    std::size_t live_distant() const { return live_distant_; }
    std::size_t wide_rebuilds() const { return wide_rebuilds_; }
    /// Returns how many times the narrow and the distant neighbour list were renewed, always
    /// together.
    std::size_t renewals() const { return renewals_; }

    /// Saves or loads the neighbour lists. The lists can be loaded only into an object that was
    /// constructed with the rupture distance and the `ListRequirements` of the saved object.
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
    /// Gap between surfaces below which the wide neighbour list must contain all pairs [grain
    /// diameters], if `ListRequirements::all_in_reach` is true.
    double reach_ = narrow_skin;
    int parts_;
    ListRequirements requirements_;
    /// Largest diameter of a grain in the sample divided by the mean diameter [1].
    double largest_ = 1;
    Neighbours wide_;
    Pairs narrow_, distant_;
    std::size_t live_ = 0, live_distant_ = 0;
    /// Displacement of each grain, without the imposed flow, from the time when the wide list was
    /// made to the time when the narrow list was made [grain diameters].
    std::vector<Vector> moved_;
    double wide_strain_ = 0, narrow_strain_ = 0, strain_since_renumbered_ = 1e9;
    std::size_t wide_rebuilds_ = 0, renewals_ = 0;
    // Buffers that are members only to reuse their memory.
    std::vector<std::uint8_t> close_;
    Pairs old_narrow_, old_distant_;
};

/// Returns all pairs of grains, periodic images included, whose surfaces are closer than `gap`
/// [grain diameters]. All centres must be inside the cell. The search uses bins that are sheared
/// with the lattice (`Bins`). In a sample that is too small for bins, all pairs are tested.
/// @param parts number of threads; the result does not depend on this number
Neighbours find_pairs(const Grains& grains, const Cell& cell, double gap, int parts = 1);

/// Returns all pairs of grains, periodic images included, whose surfaces are closer than `gap`
/// [grain diameters], by testing every pair. This function is slow and is for small samples and
/// tests.
Neighbours find_pairs_by_brute_force(const Grains& grains, const Cell& cell, double gap);

}  // namespace pendular::dem
