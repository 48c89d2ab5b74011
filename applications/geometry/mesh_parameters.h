// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_mesh_parameters_h
#define mortar_contact_applications_mesh_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * Settings of the mesh of one body: a primitive or a file, then refined,
   * turned and moved. Boundary ids of the primitives stand in the help text.
   */
  struct MeshParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    std::string type = "box";
    std::string
           file; ///< For type file, absolute or from the working directory.
    double scale = 1.;
    std::vector<double>       lower, upper; ///< Box
    std::vector<unsigned int> cells;
    std::string         inner_radius, outer_radius; ///< Formulas of z, phi
    double              radius = 1., length = 1.;
    double              first_angle = 0., last_angle = 360.; ///< [deg]
    unsigned int        refinements = 0;
    std::vector<double> refine_near;
    double              refine_radius     = 0.;
    unsigned int        local_refinements = 0;
    bool                simplices         = false;
    double              distortion        = 0.;
    std::string         map;            ///< Formulas of the coordinates.
    bool                merges = false; ///< Vertices at one place.
    std::string         boundary_ids;   ///< Formula.
    std::vector<double> rotation_axis  = {0., 0., 1.}, move;
    double              rotation_angle = 0.; ///< [deg]

    /// Of drivers with a geometry of their own: this makes the mesh of a solid
    /// (shell), and nothing above counts.
    std::function<void(Triangulation<3> &)>    make_solid;
    std::function<void(Triangulation<2, 3> &)> make_shell;
  };
} // namespace Structure

#endif
