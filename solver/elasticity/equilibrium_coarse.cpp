#include "solver/elasticity/equilibrium_coarse.hpp"

#include "solver/elasticity/equilibrium_rigid.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

namespace cleave::elasticity {

namespace {

/// Added to the diagonal of Z'KZ, relative: a free body's is singular, and CG projects its rigid motions off.
constexpr double shift = 1e-8;

/// On the diagonal of a lump that is a whole free piece (a coarse mesh: fewer particles than a lump holds), whose rigid motions meet no
/// stiffness at all: CG projects them off, and the second level has nothing to correct.
constexpr double without_stiffness = std::numeric_limits<double>::max();

using Row = Eigen::Matrix<double, 6, 6>;  ///< six strains of the six motions of a lump

/// A quantity of up to six components as a linear function of the motions of the few lumps it touches.
struct LocalMap {
    std::vector<int> lump;
    std::vector<Row> part;

    Row& of(int number) {
        for (std::size_t n = 0; n < lump.size(); ++n)
            if (lump[n] == number) return part[n];
        lump.push_back(number);
        part.push_back(Row::Zero());
        return part.back();
    }
};

/// Strain (Voigt, engineering shear) of v (x) b for v = motion m: columns by m.
Row strain_of_motion(const Eigen::Matrix<double, 3, 6>& motion, const Eigen::Vector3d& b) {
    Row strain;
    strain.row(0) = b.x() * motion.row(0);
    strain.row(1) = b.y() * motion.row(1);
    strain.row(2) = b.z() * motion.row(2);
    strain.row(3) = b.z() * motion.row(1) + b.y() * motion.row(2);
    strain.row(4) = b.z() * motion.row(0) + b.x() * motion.row(2);
    strain.row(5) = b.y() * motion.row(0) + b.x() * motion.row(1);
    return strain;
}

/// Sums Z'KZ in blocks of 6x6.
class Galerkin {
public:
    Galerkin(const CoarseSpace& space, const QuadraticEnergy& energy, const GradientStencils& stencils)
        : space_(space), energy_(energy), body_(*energy.body), stencils_(stencils) {}

    Eigen::SparseMatrix<double> sum() {
        for (int i = 0; i < body_.particles.size(); ++i) add_strain(i);
        for (int f = 0; f < body_.faces.size(); ++f)
            if (energy_.link[f] > 0) add_link(f);
        for (std::size_t n = 0; n < energy_.prescribed.size(); ++n) add_prescribed(n);
        return to_matrix();
    }

private:
    LocalMap strains(int i) const {
        LocalMap map;
        for (std::size_t n = stencils_.offset[i]; n < stencils_.offset[i + 1]; ++n) {
            const int k = stencils_.index[n];
            map.of(space_.lump_of(k)) += strain_of_motion(space_.motion(k), stencils_.weight[n]);
        }
        return map;
    }

    void add_strain(int i) {
        const LocalMap map = strains(i);
        if (map.lump.size() == 1) return;  // rigid
        const material::Stiffness weighted = body_.particles.volume[i] * body_.solid.of(i);
        for (std::size_t n = 0; n < map.lump.size(); ++n) {
            const Row stress = weighted * map.part[n];
            for (std::size_t m = 0; m < map.lump.size(); ++m) add(map.lump[m], map.lump[n], map.part[m].transpose() * stress);
        }
    }

    /// The mismatch of a link, three components: u_j - u_i - sum_k (b_ik.d_i + b_jk.d_j) u_k.
    void add_link(int f) {
        const Face& face = body_.faces.faces[f];
        LocalMap map;
        map.of(space_.lump_of(face.inside)).topRows<3>() -= space_.motion(face.inside);
        map.of(space_.lump_of(face.outside)).topRows<3>() += space_.motion(face.outside);
        add_slope(map, face.inside, energy_.link_inside[f]);
        add_slope(map, face.outside, energy_.link_outside[f]);
        if (map.lump.size() == 1) return;
        for (std::size_t n = 0; n < map.lump.size(); ++n)
            for (std::size_t m = 0; m < map.lump.size(); ++m)
                add(map.lump[m], map.lump[n], energy_.link[f] * (map.part[m].topRows<3>().transpose() * map.part[n].topRows<3>()));
    }

    void add_slope(LocalMap& map, int i, const Eigen::Vector3d& d) const {
        for (std::size_t n = stencils_.offset[i]; n < stencils_.offset[i + 1]; ++n) {
            const int k = stencils_.index[n];
            map.of(space_.lump_of(k)).topRows<3>() -= stencils_.weight[n].dot(d) * space_.motion(k);
        }
    }

    void add_prescribed(std::size_t at) {
        const PrescribedFace& prescribed = energy_.prescribed[at];
        const Face& face = body_.faces.faces[prescribed.face];
        LocalMap map = strains(face.inside), trace;  // the same lumps, since a face's stencil is part of its particle's
        for (std::size_t n = body_.traces.offset[prescribed.face]; n < body_.traces.offset[prescribed.face + 1]; ++n) {
            const int k = body_.traces.particle[n];
            trace.of(space_.lump_of(k)).topRows<3>() += body_.traces.weight[n] * space_.motion(k);
        }
        for (std::size_t n = 0; n < map.lump.size(); ++n) {
            const auto reaction = reaction_of(face, prescribed, map.part[n]);
            for (std::size_t m = 0; m < trace.lump.size(); ++m) {
                const Row work = trace.part[m].topRows<3>().transpose() * reaction;
                add(trace.lump[m], map.lump[n], -work);
                add(map.lump[n], trace.lump[m], -work.transpose());
            }
        }
        for (std::size_t n = 0; n < trace.lump.size(); ++n)
            for (std::size_t m = 0; m < trace.lump.size(); ++m)
                add(trace.lump[m], trace.lump[n],
                    trace.part[m].topRows<3>().transpose() * energy_.nitsche[at] * trace.part[n].topRows<3>());
    }

    /// P (sigma A n) of the strains of six motions.
    Eigen::Matrix<double, 3, 6> reaction_of(const Face& face, const PrescribedFace& prescribed, const Row& strain) const {
        const Row stress = body_.solid.of(face.inside) * strain;
        Eigen::Matrix<double, 3, 6> force;
        for (int m = 0; m < 6; ++m)
            force.col(m) = prescribed.mask.asDiagonal() * (material::stress_from_voigt(stress.col(m)) * face.area);
        return force;
    }

    void add(int row, int column, const Row& block) {
        if (row >= column) blocks_.try_emplace({row, column}, Row::Zero()).first->second += block;
    }

    Eigen::SparseMatrix<double> to_matrix() const {
        std::vector<Eigen::Triplet<double>> triplets;
        for (const auto& [at, block] : blocks_)
            for (int a = 0; a < 6; ++a)
                for (int b = 0; b < 6; ++b)
                    if (at.first > at.second || a >= b) triplets.emplace_back(6 * at.first + a, 6 * at.second + b, block(a, b));
        Eigen::SparseMatrix<double> matrix(6 * space_.lumps(), 6 * space_.lumps());
        matrix.setFromTriplets(triplets.begin(), triplets.end());
        return matrix;
    }

    const CoarseSpace& space_;
    const QuadraticEnergy& energy_;
    const ConformingBody& body_;
    const GradientStencils& stencils_;
    std::map<std::pair<int, int>, Row> blocks_;
};

void halve(const Vectors& position, std::vector<int> group, std::size_t most, std::vector<std::vector<int>>& groups) {
    if (group.size() <= most) {
        std::sort(group.begin(), group.end());
        groups.push_back(std::move(group));
        return;
    }
    Eigen::AlignedBox3d box;
    for (const int i : group) box.extend(position[i]);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
    std::nth_element(group.begin(), middle, group.end(), [&](int a, int b) {
        const double x = position[a][axis], y = position[b][axis];
        return x < y || (x == y && a < b);
    });
    halve(position, {group.begin(), middle}, most, groups);
    halve(position, {middle, group.end()}, most, groups);
}

}  // namespace

std::vector<std::vector<int>> halved_groups(const Vectors& position, int most) {
    std::vector<int> all(position.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<std::vector<int>> groups;
    halve(position, std::move(all), static_cast<std::size_t>(most), groups);
    return groups;
}

CoarseSpace::CoarseSpace(const QuadraticEnergy& energy, const GradientStencils& stencils, int lump_size)
    : position_(energy.body->particles.position) {
    make_lumps(position_, lump_size);
    matrix_ = Galerkin(*this, energy, stencils).sum();
    Eigen::SparseMatrix<double> shifted = matrix_;
    for (int n = 0; n < shifted.cols(); ++n) {
        double& diagonal = shifted.coeffRef(n, n);
        diagonal = diagonal > 0 ? (1 + shift) * diagonal : without_stiffness;
    }
    factor_.compute(shifted);
    if (factor_.info() != Eigen::Success) throw std::runtime_error("equilibrium: a coarse stiffness that can be factorised");
}

void CoarseSpace::make_lumps(const Vectors& position, int lump_size) {
    lump_.resize(position.size());
    first_.push_back(0);
    for (const std::vector<int>& group : halved_groups(position, lump_size)) {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        double spread = 0;
        for (const int i : group) {
            lump_[i] = lumps();
            member_.push_back(i);
            centre += position[i] / static_cast<double>(group.size());
        }
        for (const int i : group) spread += (position[i] - centre).squaredNorm() / static_cast<double>(group.size());
        centre_.push_back(centre);
        size_.push_back(spread > 0 ? std::sqrt(spread) : 1);
        first_.push_back(static_cast<int>(member_.size()));
    }
}

Eigen::Matrix<double, 3, 6> CoarseSpace::motion(int i) const {
    const int lump = lump_[i];
    return rigid_basis((position_[i] - centre_[lump]) / size_[lump]);
}

void CoarseSpace::add_correction(const Vectors& residual, Vectors& correction) const {
    Eigen::VectorXd coarse(6 * lumps());
    parallel_for_each(lumps(), [&](int lump) {
        Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
        for (int n = first_[lump]; n < first_[lump + 1]; ++n) sum += motion(member_[n]).transpose() * residual[member_[n]];
        coarse.segment<6>(6 * lump) = sum;
    });
    coarse = factor_.solve(coarse).eval();
    parallel_for_each(static_cast<int>(residual.size()), [&](int i) { correction[i] += motion(i) * coarse.segment<6>(6 * lump_[i]); });
}

}  // namespace cleave::elasticity
