#include "validation/studies/fem_indentation.hpp"

#include "reference_fem/contact.hpp"
#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/material/material.hpp"
#include "validation/geometry/contact_block.hpp"
#include "validation/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::validation {

namespace {

struct Setup {
    material::Material material;
    bool sphere = false;
    double radius = 0;  ///< of the punch's circle or of the sphere, m
    double force = 0;   ///< N, sphere
    double depth = 0;   ///< m, punch
    geometry::ContactBlock block;
    std::vector<double> quick, full;     ///< element sizes under the contact, m
    std::vector<double> stress_depths;   ///< in contact radii
    std::vector<std::string> methods;
    std::string file;
};

fem::IndentationResult solve(const Setup& setup, double size, int degree, const std::filesystem::path& meshes) {
    const geometry::Body body = geometry::mesh_contact_block(setup.block, size, meshes);
    fem::Indentation problem;
    problem.mesh_file = body.mesh_file.string();
    problem.regions = {{.id = body.regions.at("body"), .stiffness = plain_stiffness(setup.material.stiffness)}};
    const auto hold = [&](const char* name, std::array<bool, 3> components) {
        const auto found = body.surfaces.find(name);
        if (found != body.surfaces.end()) problem.symmetry.push_back({found->second, components, [](const fem::Point&) { return fem::Point{}; }});
    };
    hold("symmetry_x", {true, false, false});
    hold("symmetry_y", {false, true, false});
    problem.share = 1.0 / setup.block.sectors;
    problem.contact = body.surfaces.at("contact");
    problem.outer = body.surfaces.at("outer");
    problem.shape = setup.sphere ? fem::Indentation::Shape::sphere : fem::Indentation::Shape::flat_punch;
    problem.radius = setup.radius;
    problem.force = setup.force;
    problem.depth = setup.depth;
    fem::Options options;
    options.degree = degree;
    try {
        return fem::solve_indentation(problem, options);
    } catch (const fem::Error& error) {
        throw InputError(setup.file, "study", std::string("an indentation that can be solved: ") + error.what());
    }
}

void add_values(const Setup& setup, const fem::IndentationResult& result, const std::string& method, double size, StudyOutcome& outcome) {
    const fem::SolveRecord& record = result.solution.record();
    const Resolution resolution{size, record.cells, record.dofs};
    const auto add = [&](const char* quantity, const std::string& place, double value) {
        outcome.values.push_back({quantity, method, place, value, resolution});
    };
    add("force", "whole body", result.force);
    add("depth", "whole body", result.depth);
    add("contact_radius", "whole body", result.contact_radius);
    if (setup.sphere) add("peak_pressure", "whole body", result.peak_pressure);
    if (!setup.sphere) add("indentation_modulus", "whole body", result.force / (2 * setup.radius * result.depth));
    for (const double depth : setup.stress_depths) {
        const double z = -depth * result.contact_radius;
        add("axial_stress", fmt::format("{} a below", depth), result.solution.recovered_at({{0, 0, z}}).front().stress[2]);
    }
    outcome.solves.push_back({method, "cholmod, condensed contact", record.cells, record.dofs, record.iterations, record.relative_residual, record.seconds, record.matrix_bytes});
}

/// The pressure over the radius, finest mesh, as points for the report.
Artifact write_pressure(const fem::IndentationResult& result, const StudyContext& context) {
    std::vector<std::pair<double, double>> points;
    for (const fem::PressureSample& sample : result.pressure)
        points.emplace_back(std::hypot(sample.position[0], sample.position[1]) / result.contact_radius, sample.pressure / result.peak_pressure);
    std::sort(points.begin(), points.end());
    std::string text = "r/a,FEM,Hertz\n";
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 300);
    for (std::size_t i = 0; i < points.size(); i += stride) {
        const double r = points[i].first;
        text += fmt::format("{:.6g},{:.6g},{:.6g}\n", r, points[i].second, std::sqrt(std::max(0.0, 1 - r * r)));
    }
    const std::string file = context.folder + "/pressure.csv";
    write_file_atomic(context.out / file, text);
    return {file, "Contact pressure", "r/a", "pressure / peak pressure"};
}

class FemIndentation final : public Study {
public:
    explicit FemIndentation(Setup setup) : setup_(std::move(setup)) {}

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        const std::vector<double>& sizes = context.level == "full" && !setup_.full.empty() ? setup_.full : setup_.quick;
        for (const std::string& method : setup_.methods)
            for (const double size : sizes) {
                const fem::IndentationResult result = solve(setup_, size, method == "fem.p1" ? 1 : 2, context.meshes);
                add_values(setup_, result, method, size, outcome);
                if (setup_.sphere && method == "fem.p2" && size == sizes.back()) outcome.artifacts.push_back(write_pressure(result, context));
                if (context.progress) context.progress(fmt::format("{} size {:.4g} m", method, size));
            }
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return {setup_.material.stiffness}; }

private:
    Setup setup_;
};

std::vector<double> read_sizes(TableReader& study, const std::string& key, double unit) {
    std::vector<double> sizes = study.numbers(key);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (!(sizes[i] > 0 && sizes[i] < 1)) study.fail(key, "sizes relative to zone_radius (sphere) or radius (punch), between 0 and 1");
        if (i > 0 && !(sizes[i] < sizes[i - 1])) study.fail(key, "sizes from coarse to fine");
    }
    for (double& size : sizes) size *= unit;
    return sizes;
}

double positive(TableReader& study, const std::string& key, Dimension dimension) {
    const double value = study.quantity(key, dimension);
    if (!(value > 0)) study.fail(key, "a positive quantity");
    return value;
}

std::shared_ptr<const Study> read(TableReader& study) {
    Setup setup;
    setup.file = study.file();
    TableReader material = study.table("material");
    setup.material = material::read_material(material);
    setup.sphere = study.choice("indenter", {"flat_punch", "sphere"}) == "sphere";
    setup.radius = positive(study, "radius", dimension::length);
    setup.block.contact_radius = setup.radius;
    if (setup.sphere) {
        setup.force = positive(study, "force", dimension::force);
        setup.block.contact_radius = positive(study, "zone_radius", dimension::length);
    } else {
        setup.depth = positive(study, "depth", dimension::length);
        setup.block.rim_refinement = study.number_or("rim_refinement", 8);
        if (!(setup.block.rim_refinement >= 1)) study.fail("rim_refinement", "a number from 1");
    }
    setup.block.half_width = positive(study, "half_width", dimension::length);
    if (!(setup.block.half_width > 3 * setup.block.contact_radius)) study.fail("half_width", "more than three times the radius of the contact");
    const std::string sector = study.choice_or("sector", {"full", "half", "quarter"}, "full");
    setup.block.sectors = sector == "full" ? 1 : sector == "half" ? 2 : 4;
    setup.quick = read_sizes(study, "quick", setup.block.contact_radius);
    if (study.has("full")) setup.full = read_sizes(study, "full", setup.block.contact_radius);
    if (study.has("stress_depths")) setup.stress_depths = study.numbers("stress_depths");
    setup.methods = study.has("methods") ? study.strings("methods") : std::vector<std::string>{"fem.p2"};
    for (const std::string& method : setup.methods)
        if (method != "fem.p1" && method != "fem.p2") study.fail("methods", "fem.p1, fem.p2");
    return std::make_shared<FemIndentation>(std::move(setup));
}

}  // namespace

StudyInfo fem_indentation_study() {
    return {"fem_indentation",
            "a rigid, frictionless punch or sphere on a half-space of any stiffness, by finite elements",
            {"material", "indenter", "radius", "force (sphere)", "zone_radius (sphere)", "depth (punch)", "rim_refinement (punch)", "half_width", "sector",
             "quick", "full", "stress_depths", "methods"},
            {{"force", dimension::force},
             {"depth", dimension::length},
             {"contact_radius", dimension::length},
             {"peak_pressure", dimension::pressure},
             {"indentation_modulus", dimension::pressure},
             {"axial_stress", dimension::pressure}},
            {"fem.p1", "fem.p2"},
            read};
}

}  // namespace cleave::validation
