#include "solver/material/material.hpp"

#include "solver/material/rotation.hpp"
#include "solver/material/stiffness_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace cleave::material {

namespace {

/// The catalogue's entry for `name`, with its failures put at the key of the file that asked.
Material from_catalogue(TableReader& reader, const std::string& name) {
    if (!in_catalogue(name))
        reader.fail("name", fmt::format("a material of the catalogue ({}), or stiffness, engineering or cubic beside the name (not '{}')",
                                        fmt::join(catalogue_names(), ", "), name));
    return find_material(name);
}

Material read_base(TableReader& reader) {
    const std::string name = reader.string_or("name", "");
    if (const auto given = read_stiffness(reader)) {
        Material material;
        material.name = name;
        material.symmetry = given->symmetry;
        material.stiffness = given->stiffness;
        return material;
    }
    if (!reader.has("name")) reader.fail("", "a catalogue name, or one of stiffness, engineering, cubic");
    return from_catalogue(reader, name);
}

void read_positive(TableReader& reader, const std::string& key, Dimension dimension, double& value) {
    if (!reader.has(key)) return;
    value = reader.quantity(key, dimension);
    if (!(value > 0)) reader.fail(key, "a value above zero");
}

void replace_source(std::vector<Source>& sources, const Source& source) {
    std::erase_if(sources, [&](const Source& old) { return !source.property.empty() && old.property == source.property; });
    sources.push_back(source);
}

void read_sources(TableReader& reader, std::vector<Source>& sources) {
    if (reader.has("source"))
        for (const std::string& text : reader.strings("source")) replace_source(sources, {"", text});
    if (auto table = reader.table_if("sources"))
        for (const std::string& property : table->keys()) replace_source(sources, {property, table->string(property)});
}

}  // namespace

Material read_material(TableReader& reader) {
    Material material = read_base(reader);
    material.about = reader.string_or("about", material.about);
    const Eigen::Matrix3d rotation = read_rotation(reader);
    if (!rotation.isIdentity(0)) material.stiffness = rotate_stiffness(material.stiffness, rotation);
    read_positive(reader, "density", dimension::density, material.density);
    read_positive(reader, "strength", dimension::pressure, material.strength);
    read_positive(reader, "toughness", dimension::energy_per_area, material.toughness);
    read_sources(reader, material.sources);
    return material;
}

Material read_material_file(const std::string& path) {
    TableReader file = TableReader::from_file(path);
    if (!file.has("material")) {
        Material material = read_material(file);
        file.finish();
        return material;
    }
    TableReader table = file.table("material");
    Material material = read_material(table);
    table.finish();
    return material;
}

}  // namespace cleave::material
