#include "solver/input/input_error.hpp"
#include "solver/material/catalogue_data.hpp"
#include "solver/material/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace cleave::material {

namespace {

/// Letters and digits in lower case: what counts when names are compared.
std::string folded(std::string_view name) {
    std::string result;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c))) result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::string name_of(const CatalogueFile& file) { return TableReader::from_text(file.text, "catalogue/" + file.name).string("name"); }

const CatalogueFile* find_file(std::string_view name) {
    for (const CatalogueFile& file : catalogue_files())
        if (folded(name_of(file)) == folded(name)) return &file;
    return nullptr;
}

}  // namespace

std::vector<std::string> catalogue_names() {
    std::vector<std::string> names;
    for (const CatalogueFile& file : catalogue_files()) names.push_back(name_of(file));
    std::sort(names.begin(), names.end());
    return names;
}

bool in_catalogue(std::string_view name) { return find_file(name) != nullptr; }

Material find_material(std::string_view name) {
    const CatalogueFile* file = find_file(name);
    if (!file)
        throw InputError("", "material", fmt::format("one of {} (not '{}')", fmt::join(catalogue_names(), ", "), name));
    TableReader reader = TableReader::from_text(file->text, "catalogue/" + file->name);
    Material material = read_material(reader);
    reader.finish();
    return material;
}

}  // namespace cleave::material
