#include "validation/study.hpp"

#include "validation/studies/algorithm_1.hpp"
#include "validation/studies/contact_cross.hpp"
#include "validation/studies/contact_fields.hpp"
#include "validation/studies/contact_hertz.hpp"
#include "validation/studies/contact_indentation.hpp"
#include "validation/studies/contact_thin_wall.hpp"
#include "validation/studies/fem_indentation.hpp"
#include "validation/studies/griffith.hpp"
#include "validation/studies/kernel_properties.hpp"
#include "validation/studies/material_sweep.hpp"
#include "validation/studies/principal_directions.hpp"
#include "validation/studies/scene_claims.hpp"
#include "validation/studies/seeded_contacts.hpp"

#include <algorithm>

namespace cleave::validation {

const std::vector<StudyInfo>& studies() {
    static const std::vector<StudyInfo> list{
        fem_indentation_study(),
        kernel_properties_study(),
        contact_hertz_study(),
        contact_fields_study(),
        contact_indentation_study(),
        contact_cross_study(),
        contact_thin_wall_study(),
        principal_directions_study(),
        algorithm_1_study(),
        griffith_study(),
        scene_claims_study(),
        seeded_contacts_study(),
        material_sweep_study(),
    };
    return list;
}

Side StudyInfo::side(const std::string& method) const {
    if (method.starts_with("fem")) return Side::fem;
    return std::find(mathematics.begin(), mathematics.end(), method) == mathematics.end() ? Side::particles : Side::mathematics;
}

const StudyInfo& study_info(TableReader& study) {
    std::vector<std::string> names;
    for (const StudyInfo& info : studies()) names.push_back(info.name);
    const std::string name = study.choice("name", names);
    for (const StudyInfo& info : studies())
        if (info.name == name) return info;
    study.fail("name", "a known study");
}

}  // namespace cleave::validation
