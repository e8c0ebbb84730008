#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "data/recordings/file_view.h"
#include "python/bindings.h"
#include "python/convert.h"
#include "workflow/begin_study.h"
#include "workflow/file_views.h"
#include "workflow/json/measurements.h"
#include "workflow/study_input.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

py::dict columns_of(const IntervalSeries& series) {
    py::dict columns;
    columns["line"] =
        py::array_t<int>(static_cast<py::ssize_t>(series.line.size()), series.line.data());
    for (const SeriesColumn& column : series_columns())
        if (const auto& values = series.*column.values; !values.empty())
            columns[py::str(std::string(column.name))] = to_numpy(values);
    return columns;
}

py::tuple import_file(const std::filesystem::path& path, const FileFormat& format) {
    FileView view;
    nlohmann::ordered_json json;
    {
        const py::gil_scoped_release release;
        view = view_of_file(path, format, cell_beside(path));
        json = to_json(view);
    }
    py::list series;
    for (const IntervalSeries& each : view.series)
        series.append(columns_of(each));
    return py::make_tuple(to_python(json), series);
}

}  // namespace

void bind_files(py::module_& module) {
    module.def("import_file",
               [](const std::filesystem::path& path, const std::string& layout,
                  const std::string& encoding, const std::string& decimal, const std::string& sheet,
                  const std::vector<std::string>& columns) {
                   return import_file(path, {.layout = layout,
                                             .encoding = encoding,
                                             .decimal = decimal,
                                             .sheet = sheet,
                                             .columns = columns});
               });
    module.def("begin_study", [](const std::vector<std::filesystem::path>& paths,
                                 const std::string& sheet, bool of_folder) {
        const FileFormat format{.sheet = sheet};
        std::map<std::string, std::string> files;
        std::vector<std::string> not_read;
        {
            const py::gil_scoped_release release;
            SheetViews found =
                of_folder ? views_to_begin_with(paths, format) : views_of_files(paths, format);
            files = begin_study(found.views, format);
            not_read = std::move(found.not_read);
        }
        py::dict contents;  // bytes, since a workbook is no text
        for (const auto& [name, text] : files)
            contents[py::str(name)] = py::bytes(text);
        return py::make_tuple(contents, not_read);
    });
}

}  // namespace pendular::python
