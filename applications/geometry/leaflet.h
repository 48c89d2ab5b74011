// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_leaflet_h
#define mortar_contact_applications_leaflet_h

#include <deal.II/base/parameter_handler.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * The leaflets of a heart valve in a tube along z: each fills a third of the
   * tube around x (middle surface), is attached to the tube along a curve that
   * hangs down between two commissures, and has its free edge near two planes
   * through the axis, where it will meet its neighbours. Its normal points to
   * the aorta, out of the axis and up.
   */
  struct Leaflet
  {
    static constexpr types::boundary_id attachment = 0, free_edge = 1;

    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    /// Point of the leaflet at the place (x, y) of a half disc: x = 0 is the
    /// free edge, the circle the attachment.
    Point<3>
    place(const double x, const double y) const;

    /// @param n_leaflets Each turned by 120 degrees from the last; their
    ///                   material ids are 1, 2, ...
    void
    make(const unsigned int n_leaflets, Triangulation<2, 3> &mesh) const;

    double radius = 0., height = 0., dip = 0., rounding = 0., gap = 0.,
           belly             = 0.;
    double       thickness   = 0.;
    unsigned int refinements = 0;

  private:
    /// Distance from the axis, along x, of the free edge.
    double
    edge(const double y) const;

    /// y of the commissure.
    double commissure = 0.;
  };

  /// The wall of the tube with a bulge behind each leaflet.
  struct SinusWall
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    /// Quadrilaterals whose normals point to the axis.
    /// @param radius Of the tube.
    void
    make(const double                            radius,
         std::vector<Tensor<1, 3>>              &vertices,
         std::vector<std::vector<unsigned int>> &facets) const;

    double                    depth = 0., height = 0.;
    std::vector<double>       range; ///< Of z.
    std::vector<unsigned int> cells;
  };
} // namespace Structure

#endif
