#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// List of pairs of neighbouring grains, sorted by first and then by second grain; `first` is the
/// smaller of the two grains' numbers. The separation of a pair points from the centre of grain
/// `first` to that of the periodic image `image` of grain `second`.
struct Neighbours {
    std::vector<std::int32_t> first, second;
    std::vector<std::uint8_t> image;  ///< code of the second grain's periodic image (image_code)

    std::size_t size() const { return first.size(); }
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    void append(const Neighbours& others);
    void reserve(std::size_t count);

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(first, second, image);
    }
};

/// Pairs of grains with their contact history, as a structure of arrays.
struct Pairs : Neighbours {
    std::vector<double> sx, sy, sz;  ///< tangential force on the second grain [a^2 s22]
    std::vector<double> root;        ///< sqrt(overlap/a) at the last step, 0 without contact
    std::vector<double> bridge;      ///< 1 where a liquid bridge joins the grains, else 0
    /// Values that physical effects on grains store from step to step for each pair:
    /// contact_history[value][pair].
    std::vector<std::vector<double>> contact_history;

    Pairs() = default;
    explicit Pairs(Neighbours neighbours, std::size_t words = 0);
    void clear();
    void reserve(std::size_t count);
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    /// Adds placeholder pairs, which never touch, until the number of pairs is a multiple of
    /// `batch`.
    void fill_up(std::size_t batch);
    /// Copies the contact history (tangential force, overlap, bridge and the values of effects) of
    /// pair `from` of another list to pair `to` of this list.
    void remember(std::size_t to, const Pairs& other, std::size_t from);

    template <typename Archive>
    void serialize(Archive& archive) {
        Neighbours::serialize(archive);
        archive(sx, sy, sz, root, bridge, contact_history);
    }
};

/// Requirements that the physical effects on grains in a run have of its neighbour lists
/// (PairList).
struct ListWants {
    std::size_t contact_history = 0;  ///< number of values that effects store for each pair
    /// Whether the distant list must hold all pairs that a liquid bridge could join, not only pairs
    /// that one joins: needed where bridges form without contact.
    bool all_in_reach = false;
};

/// Neighbour lists of a sample. The wide list holds all pairs that may come close or be joined by a
/// bridge. The narrow list holds the pairs of the wide list that touch or may touch soon, so that
/// the force loop visits hardly any other pair. The distant list holds the other pairs of the wide
/// list that a bridge joins.
///
/// A list stays valid while no pair outside it can have come too close. Two grains that were
/// further apart than 1 + skin when the list was made remain further apart than a distance d while
///     (1 + skin - 2 u (1 + g)) (1 - g) > d,
/// 1 being the largest grain diameter, u the largest peculiar displacement of any grain and g the
/// affine strain (shear plus changes of the cell's edges) since the list was made. The criterion
/// covers the moving offset of the periodic images.
///
/// Grains are renumbered in rows along the flow (`order_in_rows`) whenever shear has mixed them, so
/// that the force loop reads memory in order.
class PairList {
  public:
    /// Number of pairs in a batch, which the force loop processes at once. Narrow and distant list
    /// are filled up to whole batches with placeholders.
    static constexpr std::size_t batch = 64;
    static constexpr double shortest_wide_skin = 0.2;
    static constexpr double narrow_skin = 0.02;

    /// Makes empty lists for liquid bridges that break at the gap `rupture_distance` [diameters];
    /// 0: no bridges. The lists are renewed by `parts` threads, whose number does not change them.
    explicit PairList(double rupture_distance = 0, int parts = 1, const ListWants& wants = {});

    /// Renews the neighbour lists that are no longer valid after a time step that strained the cell
    /// by `affine_strain` [1], given the displacements that `grains` holds. When the wide list is
    /// renewed, the grains are wrapped into the cell and may be renumbered.
    void update(Grains& grains, Cell& cell, double affine_strain);
    /// Renews the neighbour lists that are no longer valid, for callers that already know
    /// `largest_squared`: the largest squared peculiar displacement of a grain since the narrow
    /// list was made [a^2].
    void update(Grains& grains, Cell& cell, double affine_strain, double largest_squared);

    /// Renews wide, narrow and distant list now, keeping the contact history of their pairs; wraps
    /// the grains into the cell and renumbers them where shear has mixed them.
    void rebuild(Grains& grains, Cell& cell);

    Pairs& narrow() { return narrow_; }
    const Pairs& narrow() const { return narrow_; }
    /// Number of real pairs in the narrow list; after them, placeholder pairs fill up the last
    /// batch.
    std::size_t live() const { return live_; }
    /// Distant list: pairs without contact that a bridge joined, or could join, when the list was
    /// made. None of them can have come into contact since.
    Pairs& distant() { return distant_; }
    const Pairs& distant() const { return distant_; }
    std::size_t live_distant() const { return live_distant_; }
    std::size_t wide_rebuilds() const { return wide_rebuilds_; }
    /// Number of times that the narrow and the distant list were renewed.
    std::size_t renewals() const { return renewals_; }

    /// Saves or loads the lists. Lists can be loaded only into an object that was made for the same
    /// rupture distance.
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
    double reach_ = narrow_skin;  ///< gap [diameters] below which the wide list must hold all pairs
    int parts_;
    ListWants wants_;
    double largest_ = 1;  ///< largest grain diameter
    Neighbours wide_;
    Pairs narrow_, distant_;
    std::size_t live_ = 0, live_distant_ = 0;
    /// Peculiar displacement of each grain between the making of the wide list and of the narrow
    /// list.
    std::vector<Vector> moved_;
    double wide_strain_ = 0, narrow_strain_ = 0, strain_since_renumbered_ = 1e9;
    std::size_t wide_rebuilds_ = 0, renewals_ = 0;
    // Buffers that are members only to reuse their memory.
    std::vector<std::uint8_t> close_;
    Pairs old_narrow_, old_distant_;
};

/// Returns all pairs of grains, periodic images included, whose surfaces are closer than `gap`
/// [diameters]; all centres must lie inside the cell. Searches bins that are sheared with the
/// lattice (`Bins`), or tests all pairs if the sample is too small for bins. The work is done by
/// `parts` threads, whose number does not change the result.
Neighbours find_pairs(const Grains& grains, const Cell& cell, double gap, int parts = 1);

/// Returns all pairs of grains whose surfaces are closer than `gap` [diameters], as `find_pairs`
/// does, by testing every pair of grains: slow, for small samples and as the reference in tests.
Neighbours find_pairs_by_brute_force(const Grains& grains, const Cell& cell, double gap);

}  // namespace pendular::dem
