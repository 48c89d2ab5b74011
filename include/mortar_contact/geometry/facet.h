// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_facet_h
#define mortar_contact_geometry_facet_h

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace MortarContact
{
  using namespace dealii;

  /// Vertices a facet can have: lines in 2d; triangles, quadrilaterals in 3d.
  template <int dim>
  constexpr unsigned int max_vertices = (dim == 2) ? 2 : 4;

  /// Components of the positions of all vertices of one facet, at the most.
  template <int dim>
  constexpr unsigned int max_facet_components = dim *max_vertices<dim>;

  /// Components of the positions of all vertices of a pair, at the most.
  template <int dim>
  constexpr unsigned int max_pair_components = 2 * max_facet_components<dim>;

  /// Coordinates in a facet's reference domain, or in a facet's plane.
  template <int dim>
  using PlanePoint = Tensor<1, dim - 1>;

  /**
   * One-sided straight-edged facet: a line (dim = 2), a triangle or a bilinear,
   * possibly warped, quadrilateral (dim = 3).
   *
   * Vertices run so that the outward normal, see centre_normal(), points away
   * from the body: counter-clockwise seen from outside in 3d; in 2d with the
   * body on the left when walking from vertex 0 to vertex 1.
   *
   * Reference domains: [0,1], the unit triangle, and the unit square.
   */
  template <int dim>
  struct Facet
  {
    /// 2 (2d), 3 or 4.
    unsigned int n_vertices = max_vertices<dim>;
    /// Positions of the vertices [length of the mesh].
    std::array<Tensor<1, dim>, max_vertices<dim>> x = {};

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_vertices &x;
    }
  };

  /// Numbers per vertex of one facet; entries beyond n_vertices are zero.
  template <int dim>
  using VertexValues = std::array<double, max_vertices<dim>>;

  /// Shape functions of the facet with @p n_vertices vertices at @p xi.
  template <int dim>
  VertexValues<dim>
  shape_values(const unsigned int n_vertices, const PlanePoint<dim> &xi);

  /// Derivatives of the shape functions along each reference coordinate:
  /// [coordinate][vertex].
  template <int dim>
  std::array<VertexValues<dim>, dim - 1>
  shape_gradients(const unsigned int n_vertices, const PlanePoint<dim> &xi);

  /// Mixed second derivative of the shape function of vertex @p a: constant on
  /// quadrilaterals, zero on lines and triangles. (The pure second derivatives
  /// of all facets vanish.)
  template <int dim>
  double
  shape_twist(const unsigned int n_vertices, const unsigned int a);

  /// Reference coordinates of the facet's centre.
  template <int dim>
  PlanePoint<dim>
  reference_centre(const unsigned int n_vertices);

  /// Reference coordinates of vertex @p a.
  template <int dim>
  PlanePoint<dim>
  reference_vertex(const unsigned int n_vertices, const unsigned int a);

  /// Whether @p xi lies in the reference domain, enlarged by @p tolerance.
  template <int dim>
  bool
  is_inside(const unsigned int     n_vertices,
            const PlanePoint<dim> &xi,
            const double           tolerance);

  /// Sum of weights times vertex positions.
  template <int dim>
  Tensor<1, dim>
  interpolate(const Facet<dim> &facet, const VertexValues<dim> &weights);

  /// Mean of the vertices: the centre of lines, triangles and quadrilaterals.
  template <int dim>
  Tensor<1, dim>
  centre(const Facet<dim> &facet);

  /**
   * Vector along the outward normal at the centre, not normalised:
   * w = (p_y, -p_x) with p = x_1 - x_0 for lines, w = p x q with
   * p = x_1 - x_0, q = x_2 - x_0 for triangles (|w| = 2 area) and the diagonals
   * p = x_2 - x_0, q = x_3 - x_1 for quadrilaterals (|w| = 2 projected area).
   */
  template <int dim>
  Tensor<1, dim>
  centre_normal(const Facet<dim> &facet);

  /// Area element |dx/dxi| at @p xi [length^(dim-1)].
  template <int dim>
  double
  area_element(const Facet<dim> &facet, const PlanePoint<dim> &xi);

  /// Area of the facet (length in 2d). Exact for plane facets; four-point rule
  /// for warped ones.
  template <int dim>
  double
  area(const Facet<dim> &facet);

  /// Largest distance between two vertices.
  template <int dim>
  double
  diameter(const Facet<dim> &facet);


  // ----------------------------------------------------------- definitions

  template <int dim>
  inline VertexValues<dim>
  shape_values(const unsigned int n_vertices, const PlanePoint<dim> &xi)
  {
    if constexpr (dim == 2)
      {
        (void)n_vertices;
        return {{1. - xi[0], xi[0]}};
      }
    else if (n_vertices == 3)
      return {{1. - xi[0] - xi[1], xi[0], xi[1], 0.}};
    else
      return {{(1. - xi[0]) * (1. - xi[1]),
               xi[0] * (1. - xi[1]),
               xi[0] * xi[1],
               (1. - xi[0]) * xi[1]}};
  }


  template <int dim>
  inline std::array<VertexValues<dim>, dim - 1>
  shape_gradients(const unsigned int n_vertices, const PlanePoint<dim> &xi)
  {
    if constexpr (dim == 2)
      {
        (void)n_vertices;
        (void)xi;
        return {{{{-1., 1.}}}};
      }
    else if (n_vertices == 3)
      return {{{{-1., 1., 0., 0.}}, {{-1., 0., 1., 0.}}}};
    else
      return {{{{xi[1] - 1., 1. - xi[1], xi[1], -xi[1]}},
               {{xi[0] - 1., -xi[0], xi[0], 1. - xi[0]}}}};
  }


  template <int dim>
  inline double
  shape_twist(const unsigned int n_vertices, const unsigned int a)
  {
    return (n_vertices == 4) ? ((a % 2 == 0) ? 1. : -1.) : 0.;
  }


  template <int dim>
  inline PlanePoint<dim>
  reference_centre(const unsigned int n_vertices)
  {
    PlanePoint<dim> xi;
    for (unsigned int c = 0; c < dim - 1; ++c)
      xi[c] = (n_vertices == 3) ? 1. / 3. : 0.5;
    return xi;
  }


  template <int dim>
  inline PlanePoint<dim>
  reference_vertex(const unsigned int n_vertices, const unsigned int a)
  {
    PlanePoint<dim> xi;
    if constexpr (dim == 2)
      {
        (void)n_vertices;
        xi[0] = a;
      }
    else
      {
        xi[0] = (a == 1 || (a == 2 && n_vertices == 4)) ? 1. : 0.;
        xi[1] = (a >= 2) ? 1. : 0.;
      }
    return xi;
  }


  template <int dim>
  inline bool
  is_inside(const unsigned int     n_vertices,
            const PlanePoint<dim> &xi,
            const double           tolerance)
  {
    double sum = 0.;
    for (unsigned int c = 0; c < dim - 1; ++c)
      {
        // written so that NaN is outside
        if (!(xi[c] >= -tolerance && xi[c] <= 1. + tolerance))
          return false;
        sum += xi[c];
      }
    return n_vertices != 3 || sum <= 1. + tolerance;
  }


  template <int dim>
  inline Tensor<1, dim>
  interpolate(const Facet<dim> &facet, const VertexValues<dim> &weights)
  {
    Tensor<1, dim> x;
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      x += weights[a] * facet.x[a];
    return x;
  }


  template <int dim>
  inline Tensor<1, dim>
  centre(const Facet<dim> &facet)
  {
    Tensor<1, dim> x;
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      x += facet.x[a];
    return x / static_cast<double>(facet.n_vertices);
  }


  template <int dim>
  inline Tensor<1, dim>
  centre_normal(const Facet<dim> &facet)
  {
    if constexpr (dim == 2)
      return cross_product_2d(facet.x[1] - facet.x[0]);
    else if (facet.n_vertices == 3)
      return cross_product_3d(facet.x[1] - facet.x[0], facet.x[2] - facet.x[0]);
    else
      return cross_product_3d(facet.x[2] - facet.x[0], facet.x[3] - facet.x[1]);
  }


  template <int dim>
  inline double
  area_element(const Facet<dim> &facet, const PlanePoint<dim> &xi)
  {
    const auto dN = shape_gradients<dim>(facet.n_vertices, xi);
    if constexpr (dim == 2)
      return interpolate(facet, dN[0]).norm();
    else
      return cross_product_3d(interpolate(facet, dN[0]),
                              interpolate(facet, dN[1]))
        .norm();
  }


  template <int dim>
  inline double
  area(const Facet<dim> &facet)
  {
    if constexpr (dim == 2)
      return (facet.x[1] - facet.x[0]).norm();
    else if (facet.n_vertices == 3)
      return 0.5 * centre_normal(facet).norm();
    else
      {
        // two-point Gauss rule in each direction
        const double s   = std::sqrt(1. / 12.);
        double       sum = 0.;
        for (const double a : {0.5 - s, 0.5 + s})
          for (const double b : {0.5 - s, 0.5 + s})
            {
              PlanePoint<dim> xi;
              xi[0] = a;
              xi[1] = b;
              sum += 0.25 * area_element(facet, xi);
            }
        return sum;
      }
  }


  template <int dim>
  inline double
  diameter(const Facet<dim> &facet)
  {
    double result = 0.;
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      for (unsigned int b = 0; b < a; ++b)
        result = std::max(result, (facet.x[a] - facet.x[b]).norm());
    return result;
  }
} // namespace MortarContact

#endif
