// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_hood_h
#define mortar_contact_applications_hood_h

#include <deal.II/base/parameter_handler.h>

#include <deal.II/grid/tria.h>

#include <array>

namespace Structure
{
  using namespace dealii;

  /**
   * A car's hood of two sheets: the outer panel, and an inner frame whose
   * flanges lie below it and whose bowls between the flanges have holes. The
   * car's nose is at x = 0, its middle at y = 0, up is z; middle surfaces.
   */
  struct Hood
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    /// Height of the outer panel.
    double
    height(const double x, const double y) const;

    /// Depth of the frame below its flanges over its largest: 0 on flanges.
    double
    bowl(const double x, const double y) const;

    /// The outer panel; boundary ids as of a box.
    void
    make_panel(Triangulation<2, 3> &mesh) const;

    /// The inner frame.
    void
    make_frame(Triangulation<2, 3> &mesh) const;

    double length = 0., width = 0., crown = 0., nose_drop = 0.,
           line_height     = 0.;
    double panel_thickness = 0., frame_thickness = 0.;
    double frame_depth = 0., flange_width = 0., hole_size = 0.;
    std::array<unsigned int, 2> flanges     = {{0, 0}};
    std::array<unsigned int, 2> panel_cells = {{0, 0}}, frame_cells = {{0, 0}};
  };
} // namespace Structure

#endif
