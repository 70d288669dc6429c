#pragma once

#include "validation/geometry/shape.hpp"
#include "validation/studies/crack_specimen.hpp"
#include "validation/study.hpp"

namespace cleave::validation {

/// Keys of the study `algorithm_1`.
struct Algorithm1Setup {
    material::Stiffness stiffness, second;                 ///< Pa; `second` lies below the interface
    double strength = 0, toughness = 0, energy_limit = 0;  ///< Pa, J/m^2, J/m^3
    std::shared_ptr<const geometry::Shape> block, laminate, plate;
    std::vector<double> sizes;                             ///< m, of the block's elements, coarse to fine
    double laminate_size = 0, plate_size = 0;              ///< m
    double contact_radius = 0, plate_contact_radius = 0;   ///< m, of the block and the laminate; of the plate
    double neighbourhood = 0;                              ///< m, radius about the contact, of the block and the laminate
    double force = 0, friction = 0;                        ///< N; tangential over normal
    int groups = 0, plate_groups = 0;
};

/// The setup's force and a tangential part along x (N) on a point of the top.
TopContact contact_on_top(const Algorithm1Setup& setup, const material::Stiffness& stiffness, const Eigen::Vector3d& point,
                          double tangential);

/// The two loads by name.
std::vector<std::pair<std::string, double>> loads(const Algorithm1Setup& setup);

/// The middle of the top of a mesh's box.
Eigen::Vector3d middle_of_top(const mesh::TetMesh& mesh);

/// Groups against the closed form by size, load and rule of grouping; the paper's literal reading.
void measure_groups(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome);

/// On the coarsest block: numbering, number of groups under each load and rule, inner radius.
void measure_invariance(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome);

/// A crack that comes from the upper layer of a laminate to the lower one.
void measure_interface(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome);

/// A plate whose kernels the user stretches along the surface or along its normal.
void measure_kernel_axes(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome);

}  // namespace cleave::validation
