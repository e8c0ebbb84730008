#include "python/convert.h"

#include <pybind11/eigen.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

namespace py = pybind11;

namespace pendular::python {
namespace {

template <typename Values>
py::array taken_over(Values values) {
    auto owner = std::make_unique<Values>(std::move(values));
    Values* const held = owner.get();
    const py::capsule free(owner.release(), [](void* p) { delete static_cast<Values*>(p); });
    constexpr auto item = static_cast<py::ssize_t>(sizeof(double));
    if (held->IsVectorAtCompileTime) return py::array_t<double>(held->size(), held->data(), free);
    return py::array_t<double>({held->rows(), held->cols()}, {item, item * held->rows()},
                               held->data(), free);
}

}  // namespace

py::object to_python(const nlohmann::ordered_json& json) {
    using Kind = nlohmann::ordered_json::value_t;
    switch (json.type()) {
        case Kind::object: {
            py::dict dict;
            for (const auto& [key, value] : json.items())
                dict[py::str(key)] = to_python(value);
            return dict;
        }
        case Kind::array: {
            py::list list(json.size());
            for (std::size_t k = 0; k < json.size(); ++k)
                list[k] = to_python(json[k]);
            return list;
        }
        case Kind::string:
            return py::str(json.get_ref<const std::string&>());
        case Kind::boolean:
            return py::bool_(json.get<bool>());
        case Kind::number_integer:
            return py::int_(json.get<std::int64_t>());
        case Kind::number_unsigned:
            return py::int_(json.get<std::uint64_t>());
        case Kind::number_float:
            return py::float_(json.get<double>());
        default:
            return py::none();
    }
}

py::array to_numpy(Eigen::VectorXd vector) {
    return taken_over(std::move(vector));
}

py::array to_numpy(Eigen::MatrixXd matrix) {
    return taken_over(std::move(matrix));
}

py::array to_numpy(const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace pendular::python
