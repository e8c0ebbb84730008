#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/page/page_curves.h"
#include "reports/page/page_story.h"
#include "reports/recording_figures.h"
#include "workflow/switched_models.h"

namespace pendular {

/// Buffer of little-endian numbers, which an HTML page embeds as base64 text.
class Bytes {
  public:
    void add(float value) { append(&value, sizeof value); }
    void add(std::int16_t value) { append(&value, sizeof value); }
    void add(std::int8_t value) { append(&value, sizeof value); }
    /// Adds the lowest `width` bytes (1, 2 or 4) of a number.
    void add_unsigned(std::uint32_t value, int width) {
        append(&value, static_cast<std::size_t>(width));
    }
    void add_floats(const Eigen::VectorXd& values);
    /// Adds the scale, the largest magnitude of the values, as a 32-bit float, then each value as
    /// an integer: greatest integer of its type x value/scale, rounded.
    template <class Integer>
    void add_scaled(const Eigen::VectorXd& values) {
        const double scale = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
        constexpr double greatest = std::numeric_limits<Integer>::max();
        add(static_cast<float>(scale));
        for (const double value : values) {
            add(static_cast<Integer>(scale > 0 ? std::lround(greatest * value / scale) : 0));
        }
    }
    std::string base64() const;

  private:
    void append(const void* value, std::size_t size);
    std::string bytes_;
};

/// Returns a text for an HTML page, with the signs of print: "±" for "+-", "−" before a negative
/// number, "µ" for the "u" of a unit after a number.
std::string page_text(std::string text);

/// Recording thinned to a few hundred points, with the ranges of rows that are averaged.
struct PageRecording {
    /// Shear stress or normal stress [Pa] (torque [N m] or normal force [N] if the file has no
    /// stresses) against the number of the row, from 1.
    struct Course {
        std::string label;  ///< name and unit, for the axis
        std::vector<std::pair<std::size_t, double>> points;
        /// Over each of `windows`; empty: no recorded value.
        std::vector<std::optional<double>> means;
    };
    std::string file;  ///< equal to `origin.file` of the readings from it
    /// Time of each row [s], never going back: intervals that begin at 0 again follow the one
    /// before. Empty: a row has no time.
    std::vector<double> time;
    std::vector<Course> courses;  ///< shear stress, then normal stress; only those with values
    std::vector<AveragedWindow> windows;
};

/// Returns the part of a recording that the page shows.
/// @param readings readings of the study; those from other files are ignored
/// @param left_out rows that the study left out, with reasons
/// @param most maximum number of points for each stress
PageRecording page_recording(const FileView& view, const std::vector<Reading>& readings,
                             const std::vector<Remark>& left_out, std::size_t most);

/// Returns the maximum number of points for each stress of a recording: 400, or fewer (at least 20)
/// if many recordings would make the page large.
std::size_t points_of_recordings(std::size_t recordings);

/// Returns the JSON of recordings, each with the name of its file, `x_label`, the ends of the x
/// axis
/// (`from`, `span`), `parts` and `windows`. The x axis is the time or, where it is not known, the
/// number of the row:
/// - A part is a stress against it: a label, the keys `low` and `range`, and the points as base64.
/// A
///   point is two unsigned 16-bit numbers j and k, little-endian: x = from + span j/65535, and the
///   value low + range k/65535.
/// - A window is a range of averaged rows: its ends along x, its kind as text, the index of the
///   reading that averages it (null: none), and the mean of each part.
/// @param readings all readings that the page shows
nlohmann::ordered_json recordings_json(const std::vector<PageRecording>& recordings,
                                       const std::vector<Reading>& readings);

/// Returns the JSON from which the page draws its panels: readings, panels, recordings, and a
/// fitted model for each combination of the effects that a reader can switch. The predictions of a
/// model are a polynomial of second order in the shifts of the parameters from the fit, in standard
/// errors.
///
/// The keys `response`, `errors`, `form` and `without` of a model are little-endian numbers as
/// base64. `response` contains, in this order:
/// - the predictions at all points (the readings, then the points of the curves) as 32-bit floats:
///   first the stress ratios, second the solid fractions
/// - the coefficients of first order, one for each parameter
/// - the coefficients of second order, one for each product of two parameters
///
/// A coefficient has a part for the stress ratio and a part for the solid fraction. Each part is a
/// scale (32-bit float) and one integer per point (`Bytes::add_scaled`): of 16 bits for the first
/// order, of 8 bits for the second, which is small where the expansion holds. The columns of
/// `without` have 16 bits.
/// @param panels panels whose curve points `models` predicts, in the order of `points_of_curves`
nlohmann::ordered_json page_data(const SwitchedModels& models, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings,
                                 const PageStory& story);

}  // namespace pendular
