#pragma once

#include "solver/contact/half_space.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/particles/wpca.hpp"
#include "validation/analytic/half_space_fourier.hpp"
#include "validation/analytic/principals.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cleave::validation {

/// How a specimen's particles are made.
struct SpecimenOptions {
    std::string strain_operator = "corrected";
    double neighbourhood = 0;                      ///< m, of kernels that choose an analysed point's neighbours; 0: the operator's own
    const particles::WpcaOptions* wpca = nullptr;  ///< kernels after the body's shape, for neighbours and operator
};

/// A body that Algorithm 1 can be run on: everything the generator refers to. Not to be moved once a generator exists.
struct CrackSpecimen {
    mesh::TetMesh mesh;
    particles::Particles particles;
    elasticity::Solid solid;
    elasticity::StrainOperator strain_operator;
    std::vector<fracture::Brittleness> brittleness;

    fracture::CrackGenerator generator() const;
};

/// `stiffness` (Pa) by region; one strength (Pa) and toughness (J/m^2) for all.
CrackSpecimen make_specimen(mesh::TetMesh mesh, const std::map<int, material::Stiffness>& stiffness, double strength, double toughness,
                            const SpecimenOptions& options = {});

/// A load on a face that looks along +z, spread like Hertz's pressure: the paper's half-space below it, computed twice.
class TopContact {
public:
    /// `force` in N on the body, x and y along the surface, z negative into the body; `radius` of the circle of contact, m.
    TopContact(const material::Stiffness& stiffness, const Eigen::Vector3d& point, const Eigen::Vector3d& force, double radius);

    fracture::AnalysedPoint analysed() const;
    /// By solver/contact. `particles` must outlive the result.
    fracture::Displacement displacement(const particles::Particles& particles) const;
    /// By validation/analytic: Fourier transform over the surface.
    analytic::Gradient exact_gradient(const Eigen::Vector3d& position) const;

private:
    Eigen::Vector3d point_, force_;
    double radius_;
    contact::HalfSpaceField field_;
    std::shared_ptr<const analytic::FourierHalfSpace> exact_;
};

/// What a group's members say in closed form: volume-weighted means of the exact gradient.
struct ExactGroup {
    analytic::Voigt strain{}, stress{};
    analytic::Principals principal_stress, principal_strain;
};

/// Exact gradients at particles, each computed once.
class ExactField {
public:
    ExactField(const TopContact& contact, const particles::Particles& particles) : contact_(contact), particles_(particles) {}
    ExactGroup group(const std::vector<int>& members, const material::Stiffness& stiffness);

private:
    const analytic::Gradient& at(int particle);

    const TopContact& contact_;
    const particles::Particles& particles_;
    std::map<int, analytic::Gradient> known_;
};

}  // namespace cleave::validation
