#include "solver/contact/half_space.hpp"

#include "solver/contact/green_table.hpp"
#include "solver/contact/isotropic_half_space.hpp"
#include "solver/contact/stroh_field.hpp"
#include "solver/contact/stroh_table.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace cleave::contact {

namespace {

/// Largest difference of unit normals that counts as rounding.
constexpr double same_normal = 1e-9;

double mean_shear_modulus(const material::Stiffness& c) { return (c(3, 3) + c(4, 4) + c(5, 5)) / 3; }
double mean_lame(const material::Stiffness& c) { return (c(0, 1) + c(0, 2) + c(1, 2)) / 3; }

bool is_ellipse(const ContactLoad& load) { return load.radius > 0 && load.other_radius > 0 && load.other_radius != load.radius; }

}  // namespace

bool is_isotropic(const material::Stiffness& c, double tolerance) {
    const double G = mean_shear_modulus(c), lambda = mean_lame(c);
    material::Stiffness model = material::Stiffness::Zero();
    model.topLeftCorner<3, 3>().setConstant(lambda);
    for (int i = 0; i < 3; ++i) {
        model(i, i) += 2 * G;
        model(i + 3, i + 3) = G;
    }
    return (c - model).cwiseAbs().maxCoeff() <= tolerance * c.cwiseAbs().maxCoeff();
}

HalfSpace::HalfSpace(const material::Stiffness& stiffness, const Eigen::Vector3d& inward, const HalfSpaceOptions& options)
    : stiffness_(stiffness), options_(options), isotropic_(is_isotropic(stiffness)) {
    const Eigen::Matrix3d axes = surface_axes(inward);
    inward_ = axes.col(2);
    if (isotropic_) {
        const double lambda = mean_lame(stiffness);
        shear_modulus_ = mean_shear_modulus(stiffness);
        poisson_ratio_ = lambda / (2 * (lambda + shear_modulus_));
    } else if (options.form == HalfSpaceForm::closed) {
        throw std::invalid_argument("an isotropic material for the closed form of a half-space");
    }
    stroh_table_ = std::make_shared<StrohTable>(material::rotate_stiffness(stiffness, axes.transpose()), options.most_directions);
    if (options.tabulated && !(isotropic_ && options.form == HalfSpaceForm::automatic) && options.form != HalfSpaceForm::closed)
        green_table_ = std::make_shared<GreenTable>(stroh_table_, axes, options.accuracy);
}

HalfSpaceField::HalfSpaceField(std::shared_ptr<const HalfSpace> half_space, const ContactLoad& load)
    : half_space_(std::move(half_space)), load_(load), axes_(surface_axes(half_space_->inward())) {
    if ((load.inward.normalized() - half_space_->inward()).norm() > same_normal)
        throw std::invalid_argument("a contact whose normal is that of its half-space");
    local_force_ = axes_.transpose() * load.force;
    const HalfSpaceForm form = half_space_->options().form;
    if (form == HalfSpaceForm::closed && is_ellipse(load)) throw std::invalid_argument("a circular patch for the closed form of a half-space");
    closed_ = form != HalfSpaceForm::stroh && half_space_->isotropic() && !is_ellipse(load);
    if (closed_) return;
    tabulated_ = half_space_->green_table() && !is_ellipse(load);
    StrohLoad local{local_force_, load.radius, load.other_radius > 0 ? load.other_radius : load.radius};
    if (is_ellipse(load)) local.axis = (axes_.transpose() * load.axis).head<2>().normalized();
    if (!(local.axis.norm() > 0)) throw std::invalid_argument("an elliptical patch with an axis in the surface");
    stroh_ = std::make_shared<StrohField>(half_space_->stroh_table(), local, half_space_->options().accuracy);
}

Eigen::Vector3d HalfSpaceField::to_local(const Eigen::Vector3d& position) const { return axes_.transpose() * (position - load_.point); }

IsotropicContact HalfSpaceField::isotropic_contact() const {
    return {half_space_->shear_modulus(), half_space_->poisson_ratio(), load_.radius, local_force_};
}

Eigen::Vector3d HalfSpaceField::displacement(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d local = to_local(position);
    if (tabulated_ && half_space_->green_table()->covers(local, load_.radius))
        return half_space_->green_table()->displacement(local, local_force_, load_.radius);
    return axes_ * (closed_ ? isotropic_displacement(isotropic_contact(), local) : stroh_->displacement(local));
}

Eigen::Matrix3d HalfSpaceField::gradient(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d local = to_local(position);
    if (!closed_) return axes_ * stroh_->gradient(local) * axes_.transpose();
    return axes_ * isotropic_gradient(isotropic_contact(), local) * axes_.transpose();
}

material::Voigt HalfSpaceField::stress(const Eigen::Vector3d& position) const {
    const Eigen::Matrix3d g = gradient(position);
    return half_space_->stiffness() * material::strain_to_voigt(0.5 * (g + g.transpose()));
}

void HalfSpaceField::displacements(std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> values) const {
    if (!closed_) {
        for (std::size_t i = 0; i < positions.size(); ++i) values[i] = displacement(positions[i]);
        return;
    }
    std::vector<Eigen::Vector3d> local;
    local.reserve(positions.size());
    for (const Eigen::Vector3d& x : positions) local.push_back(to_local(x));
    isotropic_displacements(isotropic_contact(), local, values);
    for (Eigen::Vector3d& u : values.first(positions.size())) u = axes_ * u;
}

HalfSpaceField half_space_field(const material::Stiffness& stiffness, const ContactLoad& load, const HalfSpaceOptions& options) {
    return HalfSpaceField(std::make_shared<HalfSpace>(stiffness, load.inward, options), load);
}

}  // namespace cleave::contact
