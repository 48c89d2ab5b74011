// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_rigid_parameters_h
#define mortar_contact_structure_rigid_parameters_h

#include <mortar_contact/host/rigid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// One rigid body of a scene: shape, place, motion.
  struct RigidParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    /// @param scene_length Size of the scene; formulas are differentiated over
    /// a small part of it [m].
    /// @throw ExcMessage on settings that make no body.
    template <int dim>
    std::shared_ptr<MortarContact::RigidBody<dim>>
    make(const double scene_length) const;

    /// Translation at a time.
    template <int dim>
    Tensor<1, 3>
    shift(const double time) const;

    std::string         name;
    std::string         type   = "ball";
    double              radius = 1., tube_radius = 0.5, length = 0.;
    double              half_angle = 45.; ///< [deg]
    std::vector<double> sizes;
    std::string         formula, file;
    /// For type mesh, by drivers that make it themselves: instead of the file.
    std::vector<Tensor<1, 3>>              vertices;
    std::vector<std::vector<unsigned int>> facets; ///< Normals point outward.
    double                                 scale     = 1.;
    double                                 thickness = 0.; ///< Of a sheet [m].
    bool                                   smooth    = false;
    double                                 crease_angle = 40.; ///< [deg]
    std::vector<double>                    position, axis;
    std::array<std::string, 3>             translation = {{"0", "0", "0"}};
    std::vector<double>                    rotation_axis, rotation_centre;
    std::string                            rotation_angle = "0"; ///< [rad]
    /// Motions that forces decide: "x", "y", "z", "rotation x", ...
    std::vector<std::string>   free_motions;
    std::array<std::string, 3> force = {{"0", "0", "0"}}, moment = force;

    /// Point that the body turns about, at the start.
    template <int dim>
    Tensor<1, dim>
    turning_point() const;
  };
} // namespace Structure

#endif
