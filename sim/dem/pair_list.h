#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/dem/cell.h"
#include "sim/dem/grains.h"

namespace pendular::dem {

/// Pairs of grains, ordered by first and then by second grain; `first` is the smaller number. The
/// separation points from `first` to the image of `second`.
struct Neighbours {
    std::vector<std::int32_t> first, second;
    std::vector<std::uint8_t> image;  ///< image_code of the second grain

    std::size_t size() const { return first.size(); }
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    void append(const Neighbours& others);
    void reserve(std::size_t count);

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(first, second, image);
    }
};

/// Pairs with their contact history, structure of arrays.
struct Pairs : Neighbours {
    std::vector<double> sx, sy, sz;  ///< tangential force on the second grain
    std::vector<double> root;        ///< sqrt(overlap) of the last step, 0 without contact
    std::vector<double> bridge;      ///< 1 where a liquid bridge joins the grains, else 0
    std::vector<std::vector<double>>
        contact_history;  ///< of effects: contact_history[number][pair]

    Pairs() = default;
    explicit Pairs(Neighbours neighbours, std::size_t words = 0);
    void clear();
    void reserve(std::size_t count);
    void add(std::int32_t i, std::int32_t j, std::uint8_t code);
    /// Adds pairs outside the cell, which never touch, up to a whole number of batches.
    void fill_up(std::size_t batch);
    /// Copies the contact history of pair `from` of another list to pair `to` of this one.
    void remember(std::size_t to, const Pairs& other, std::size_t from);

    template <typename Archive>
    void serialize(Archive& archive) {
        Neighbours::serialize(archive);
        archive(sx, sy, sz, root, bridge, contact_history);
    }
};

/// Requirements of effects on grains for the neighbour lists.
struct ListWants {
    std::size_t contact_history = 0;  ///< numbers of contact history per pair
    bool all_in_reach = false;        ///< the distant list has all pairs that a bridge could join
};

/// Neighbours at two ranges. The wide list holds the pairs that may come close and those a bridge
/// may join; the narrow list those that touch or may touch soon, so that the force loop sees hardly
/// anything else; the distant list those of the others that a bridge joins.
///
/// Both stay valid while no missing pair can have come too close. Two grains that were further
/// apart than 1 + skin remain further apart than a distance d while
///     (1 + skin - 2 u (1 + g)) (1 - g) > d,
/// 1 being the largest grain diameter, u the largest peculiar displacement of any grain and g the
/// affine strain (shear plus changes of the cell's edges) since then: the moving image offset is
/// part of the criterion, not a special case.
///
/// Grains are renumbered in rows when shear has carried them apart, so that memory is read in
/// order.
class PairList {
  public:
    static constexpr std::size_t batch = 64;  ///< the narrow list is filled up to whole batches
    static constexpr double shortest_wide_skin = 0.2;
    static constexpr double narrow_skin = 0.02;

    /// Bridges live up to this gap [diameters], 0 without. Lists are made in `parts` side by side,
    /// which does not change them.
    explicit PairList(double rupture_distance = 0, int parts = 1, const ListWants& wants = {});

    /// Records the displacement and affine strain of a step, and renews the lists that are no
    /// longer valid. Wraps the grains into the cell when the wide list is renewed.
    void update(Grains& grains, Cell& cell, double affine_strain);
    /// Updates the lists, given the largest squared displacement since the narrow list was made, if
    /// it is known.
    void update(Grains& grains, Cell& cell, double affine_strain, double largest_squared);

    /// Renews both lists now, keeping the contact history.
    void rebuild(Grains& grains, Cell& cell);

    Pairs& narrow() { return narrow_; }
    const Pairs& narrow() const { return narrow_; }
    /// Number of real pairs in the narrow list; the others only fill up the last batch.
    std::size_t live() const { return live_; }
    /// Pairs that a bridge joined, or could join, when the list was made; none of them can have
    /// come to touch.
    Pairs& distant() { return distant_; }
    const Pairs& distant() const { return distant_; }
    std::size_t live_distant() const { return live_distant_; }
    std::size_t wide_rebuilds() const { return wide_rebuilds_; }
    /// How often either list was renewed.
    std::size_t renewals() const { return renewals_; }

    /// Saves or loads the lists; the list loaded into must be made for the same rupture distance.
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
    double reach_ = narrow_skin;  ///< gap within which the wide list must know all pairs
    int parts_;
    ListWants wants_;
    double largest_ = 1;  ///< diameter
    Neighbours wide_;
    Pairs narrow_, distant_;
    std::size_t live_ = 0, live_distant_ = 0;
    std::vector<Vector> moved_;  ///< peculiar displacements, wide to narrow list
    double wide_strain_ = 0, narrow_strain_ = 0, strain_since_renumbered_ = 1e9;
    std::size_t wide_rebuilds_ = 0, renewals_ = 0;
    // Buffers, kept between calls so that their memory is reused.
    std::vector<std::uint8_t> close_;
    Pairs old_narrow_, old_distant_;
};

/// All pairs of grains inside the cell whose surfaces are closer than `gap`. Bins are sheared with
/// the lattice, so that the image offset needs no special case; small samples are searched whole.
/// Done in `parts` side by side, which does not change the result.
Neighbours find_pairs(const Grains& grains, const Cell& cell, double gap, int parts = 1);

/// Neighbours found by testing every pair of grains: slow; the reference for the tests of
/// `find_pairs`.
Neighbours find_pairs_by_brute_force(const Grains& grains, const Cell& cell, double gap);

}  // namespace pendular::dem
