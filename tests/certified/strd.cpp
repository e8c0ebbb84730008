#include "strd.h"

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <stdexcept>

using namespace pendular;

namespace strd {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

struct Law {
    std::string readings;
    Formula formula;
};

// The laws, with b counted from 0.

Jet misra1a(const Jet* b, const Real* x) {
    return b[0] * (1.0L - exp(-b[1] * x[0]));
}
Jet misra1b(const Jet* b, const Real* x) {
    return b[0] * (1.0L - pow(1.0L + b[1] * x[0] / 2.0L, -2.0L));
}
Jet misra1c(const Jet* b, const Real* x) {
    return b[0] * (1.0L - pow(1.0L + 2.0L * b[1] * x[0], -0.5L));
}
Jet misra1d(const Jet* b, const Real* x) {
    return b[0] * b[1] * x[0] / (1.0L + b[1] * x[0]);
}
Jet chwirut(const Jet* b, const Real* x) {
    return exp(-b[0] * x[0]) / (b[1] + b[2] * x[0]);
}
Jet lanczos(const Jet* b, const Real* x) {
    return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-b[3] * x[0]) + b[4] * exp(-b[5] * x[0]);
}
Jet gauss(const Jet* b, const Real* x) {
    const Jet u = (x[0] - b[3]) / b[4], v = (x[0] - b[6]) / b[7];
    return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-u * u) + b[5] * exp(-v * v);
}
Jet dan_wood(const Jet* b, const Real* x) {
    return b[0] * pow(x[0], b[1]);
}
Jet quadratics(const Jet* b, const Real* x) {
    return (b[0] + x[0] * (b[1] + x[0] * b[2])) / (1.0L + x[0] * (b[3] + x[0] * b[4]));
}
Jet cubics(const Jet* b, const Real* x) {
    return (b[0] + x[0] * (b[1] + x[0] * (b[2] + x[0] * b[3]))) /
           (1.0L + x[0] * (b[4] + x[0] * (b[5] + x[0] * b[6])));
}
Jet nelson(const Jet* b, const Real* x) {
    return b[0] - b[1] * x[0] * exp(-b[2] * x[1]);
}
Jet mgh09(const Jet* b, const Real* x) {
    return b[0] * x[0] * (x[0] + b[1]) / (x[0] * (x[0] + b[2]) + b[3]);
}
Jet mgh10(const Jet* b, const Real* x) {
    return b[0] * exp(b[1] / (x[0] + b[2]));
}
Jet mgh17(const Jet* b, const Real* x) {
    return b[0] + b[1] * exp(-x[0] * b[3]) + b[2] * exp(-x[0] * b[4]);
}
Jet roszman(const Jet* b, const Real* x) {
    return b[0] - b[1] * x[0] - atan(b[2] / (x[0] - b[3])) / pi;
}
Jet enso(const Jet* b, const Real* x) {
    const Real year = 2 * pi * x[0] / 12;
    const Jet u = 2 * pi * x[0] / b[3], v = 2 * pi * x[0] / b[6];
    return b[0] + b[1] * std::cos(year) + b[2] * std::sin(year) + b[4] * cos(u) + b[5] * sin(u) +
           b[7] * cos(v) + b[8] * sin(v);
}
Jet rat42(const Jet* b, const Real* x) {
    return b[0] / (1.0L + exp(b[1] - b[2] * x[0]));
}
Jet rat43(const Jet* b, const Real* x) {
    return b[0] / pow(1.0L + exp(b[1] - b[2] * x[0]), 1.0L / b[3]);
}
Jet eckerle4(const Jet* b, const Real* x) {
    const Jet u = (x[0] - b[2]) / b[1];
    return b[0] / b[1] * exp(-0.5L * u * u);
}
Jet bennett5(const Jet* b, const Real* x) {
    return b[0] * pow(b[1] + x[0], -1.0L / b[2]);
}

const std::map<std::string, Law>& laws() {
    static const std::map<std::string, Law> all = {{"Misra1a", {"Misra1a", misra1a}},
                                                   {"Misra1b", {"Misra1a", misra1b}},
                                                   {"Misra1c", {"Misra1a", misra1c}},
                                                   {"Misra1d", {"Misra1a", misra1d}},
                                                   {"Chwirut1", {"Chwirut1", chwirut}},
                                                   {"Chwirut2", {"Chwirut2", chwirut}},
                                                   {"Lanczos1", {"Lanczos1", lanczos}},
                                                   {"Lanczos2", {"Lanczos2", lanczos}},
                                                   {"Lanczos3", {"Lanczos3", lanczos}},
                                                   {"Gauss1", {"Gauss1", gauss}},
                                                   {"Gauss2", {"Gauss2", gauss}},
                                                   {"Gauss3", {"Gauss3", gauss}},
                                                   {"DanWood", {"DanWood", dan_wood}},
                                                   {"Kirby2", {"Kirby2", quadratics}},
                                                   {"Hahn1", {"Hahn1", cubics}},
                                                   {"Nelson", {"Nelson", nelson}},
                                                   {"MGH09", {"MGH09", mgh09}},
                                                   {"MGH10", {"MGH10", mgh10}},
                                                   {"MGH17", {"MGH17", mgh17}},
                                                   {"Roszman1", {"Roszman1", roszman}},
                                                   {"ENSO", {"ENSO", enso}},
                                                   {"Thurber", {"Thurber", cubics}},
                                                   {"BoxBOD", {"BoxBOD", misra1a}},
                                                   {"Rat42", {"Rat42", rat42}},
                                                   {"Rat43", {"Rat43", rat43}},
                                                   {"Eckerle4", {"Eckerle4", eckerle4}},
                                                   {"Bennett5", {"Bennett5", bennett5}}};
    return all;
}

Table table(const std::string& file) {
    return read_table(std::string(PENDULAR_SOURCE_DIR "/tests/certified/data/") + file);
}

/// The rows of a table whose first cell is `name`, without that cell.
std::vector<std::vector<double>> rows_of(const std::string& file, const std::string& name) {
    std::vector<std::vector<double>> rows;
    for (const Row& row : table(file).rows) {
        if (row.cells[0].text == name) {
            rows.emplace_back();
            for (std::size_t k = 1; k < row.cells.size(); ++k) {
                rows.back().push_back(std::stod(row.cells[k].text));
            }
        }
    }
    return rows;
}

/// A thousand times as far from zero as any start or answer, to either side.
Parameter generous(std::size_t k, double start_1, double start_2, double certified) {
    const double far = 1000 * std::max({std::abs(start_1), std::abs(start_2), std::abs(certified)});
    return {.name = fmt::format("b{}", k + 1), .lower = -far, .upper = far, .start = start_1};
}

}  // namespace

Numbers read_numbers(const std::string& file) {
    const Table text = table(file);
    Numbers numbers(text.rows.size(), text.header.cells.size());
    for (std::size_t i = 0; i < text.rows.size(); ++i) {
        for (std::size_t j = 0; j < text.header.cells.size(); ++j) {
            numbers(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                std::stold(text.rows[i].cells[j].text);
        }
    }
    return numbers;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Row& row : table("residuals.csv").rows) {
        all.push_back(row.cells[0].text);
    }
    return all;
}

DataSet data_set(const std::string& name) {
    const Law& law = laws().at(name);
    const Numbers readings = read_numbers(law.readings + ".csv");
    const auto n = readings.rows();
    DataSet set{.name = name,
                .formula = law.formula,
                .x = readings.rightCols(readings.cols() - 1),
                .y = readings.col(0)};
    if (name == "Nelson") {  // the law is one of the logarithm
        set.y = set.y.array().log();
    }
    set.measured = {Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Identity(n, n)};
    const auto rows = rows_of("parameters.csv", name);
    const auto count = static_cast<Eigen::Index>(rows.size());
    for (Eigen::VectorXd* column :
         {&set.start[0], &set.start[1], &set.certified, &set.standard_deviation}) {
        column->resize(count);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        set.start[0](i) = rows[k][0];
        set.start[1](i) = rows[k][1];
        set.certified(i) = rows[k][2];
        set.standard_deviation(i) = rows[k][3];
        set.parameters.push_back(generous(k, rows[k][0], rows[k][1], rows[k][2]));
    }
    const auto residuals = rows_of("residuals.csv", name).at(0);
    if (static_cast<double>(n) != residuals[0]) {
        throw std::logic_error(name + ": readings are missing");
    }
    set.residual_sum = residuals[1];
    set.residual_deviation = residuals[2];
    return set;
}

Prediction FormulaModel::predict(const Eigen::VectorXd& parameters,
                                 pendular::PredictionPart /*what*/) const {
    ++evaluations;
    const auto n = set_.x.rows(), count = parameters.size();
    Jet b[Jet::DIMENSION];
    for (Eigen::Index k = 0; k < count; ++k) {
        b[k] = Jet(parameters(k), static_cast<int>(k));
    }
    Prediction prediction{Eigen::VectorXd(n), Eigen::MatrixXd(n, count),
                          Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Jet y = set_.formula(b, set_.x.row(i).data());
        prediction.value(i) = static_cast<double>(y.a - set_.y(i));
        prediction.jacobian.row(i) = y.v.head(count).cast<double>();
    }
    return prediction;
}

ParameterBounds FormulaModel::bounds() const {
    const auto count = static_cast<Eigen::Index>(set_.parameters.size());
    ParameterBounds range{Eigen::VectorXd(count), Eigen::VectorXd(count)};
    for (Eigen::Index k = 0; k < count; ++k) {
        range.lower(k) = set_.parameters[static_cast<std::size_t>(k)].lower;
        range.upper(k) = set_.parameters[static_cast<std::size_t>(k)].upper;
    }
    return range;
}

double fewest_digits(const Eigen::VectorXd& x, const Eigen::VectorXd& c) {
    double fewest = 11;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const double agree = digits(x(k), c(k));
        fewest = std::isnan(agree) ? -99 : std::min(fewest, agree);
    }
    return fewest;
}

Eigen::VectorXd standard_deviations(const Fit& fit) {
    return (fit.covariance.diagonal() * fit.chi2 / fit.dof).cwiseSqrt();
}

}  // namespace strd
