// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/pair_block.h>
#include <mortar_contact/mortar/segmentation.h>

#include <cmath>

namespace MortarContact
{
  using namespace PairAlgebra;

  namespace
  {
    /// Two lines count as parallel where the sine of their angle is below this;
    /// their crossing is then taken to move with the first line.
    constexpr double parallel = 1e-9;

    /// A corner of the overlap is a thin tip where the sine of its outer angle
    /// is below this.
    constexpr double thin_tip = 0.05;

    /// Twice the area of a triangle, and its derivatives by the corners.
    double
    twice_area(const std::array<Tensor<1, 2>, 3> &y,
               std::array<Tensor<1, 2>, 3>       *derivative = nullptr)
    {
      if (derivative != nullptr)
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Tensor<1, 2> opposite = y[(k + 2) % 3] - y[(k + 1) % 3];
            (*derivative)[k][0]         = -opposite[1];
            (*derivative)[k][1]         = opposite[0];
          }
      return (y[1][0] - y[0][0]) * (y[2][1] - y[0][1]) -
             (y[1][1] - y[0][1]) * (y[2][0] - y[0][0]);
    }
  } // namespace


  template <int dim>
  ProjectedPrimary<dim>::ProjectedPrimary(const SecondaryFrame<dim> &frame,
                                          const Facet<dim>          &facet)
    : facet(facet)
    , height{}
  {
    for (unsigned int b = 0; b < facet.n_vertices; ++b)
      {
        y[b]      = frame.project(facet.x[b]);
        height[b] = frame.normal * (facet.x[b] - frame.centre);
      }
  }


  template <int dim>
  VertexMotion<dim>::VertexMotion(const SecondaryFrame<dim>   &frame,
                                  const ProjectedPrimary<dim> &primary)
    : dy{}
  {
    const auto fill = [&](const unsigned int n_vertices,
                          const auto        &height,
                          const unsigned int side) {
      for (unsigned int a = 0; a < n_vertices; ++a)
        {
          const auto motion = frame.frame_motion(height[a]);
          for (unsigned int c = 0; c < dim - 1; ++c)
            {
              PairVector<dim> &d = dy[side][a][c];
              for (unsigned int i = 0; i < max_facet_components<dim>; ++i)
                d[i] = motion[c][i];
              for (unsigned int i = 0; i < dim; ++i)
                d[side * max_facet_components<dim> + a * dim + i] +=
                  frame.basis[c][i];
            }
        }
    };
    fill(frame.facet.n_vertices, frame.height, 0);
    fill(primary.facet.n_vertices, primary.height, 1);
  }


  template <int dim>
  MortarSegments<dim>::MortarSegments(const Overlap<dim> &o)
    : overlap(o)
  {
    if constexpr (dim == 3)
      {
        double sum = 0.;
        for (unsigned int k = 1; k + 1 < overlap.n_vertices; ++k)
          {
            const std::array<PlanePoint<dim>, 3> y = {
              {overlap.vertices[0].y,
               overlap.vertices[k].y,
               overlap.vertices[k + 1].y}};
            const double a = twice_area(y);
            sum += a;
            centroid += a / 3. * (y[0] + y[1] + y[2]);
          }
        centroid /= sum;

        // Thin tips first, unless they leave something of which the centroid is
        // no part; then around the centroid what they leave.
        if (!cut(true))
          cut(false);
      }
  }


  template <int dim>
  bool
  MortarSegments<dim>::cut(const bool with_tips)
  {
    n_triangles                                           = 0;
    const unsigned int                                  n = overlap.n_vertices;
    std::array<unsigned int, max_overlap_vertices<dim>> rest;
    unsigned int                                        n_rest = 0;
    bool first_is_tip = false, last_was_tip = false;
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int     before = (k + n - 1) % n, after = (k + 1) % n;
        const PlanePoint<dim> &y       = overlap.vertices[k].y;
        const PlanePoint<dim>  e       = y - overlap.vertices[before].y;
        const PlanePoint<dim>  f       = overlap.vertices[after].y - y;
        const double           along   = e * f;
        const double           lengths = e.norm_square() * f.norm_square();
        // no two tips beside each other
        const bool has_room = with_tips && !last_was_tip &&
                              !(after == 0 && first_is_tip) &&
                              n - n_triangles > 3;
        last_was_tip = has_room && along > 0. &&
                       along * along > (1. - thin_tip * thin_tip) * lengths;
        if (k == 0)
          first_is_tip = last_was_tip;
        if (last_was_tip)
          triangles[n_triangles++] = {{before, k, after}};
        else
          rest[n_rest++] = k;
      }
    const unsigned int n_tips = n_triangles;
    for (unsigned int k = 0; k < n_rest; ++k)
      triangles[n_triangles++] = {
        {max_corners - 1, rest[k], rest[(k + 1) % n_rest]}};
    if (n_tips > 0)
      for (unsigned int s = n_tips; s < n_triangles; ++s)
        if (area(s) < 0.)
          return false;
    return true;
  }


  template <int dim>
  const PlanePoint<dim> &
  MortarSegments<dim>::corner(const unsigned int s, const unsigned int k) const
  {
    const unsigned int c = corner_index(s, k);
    return (c == max_corners - 1) ? centroid : overlap.vertices[c].y;
  }


  template <int dim>
  double
  MortarSegments<dim>::area(const unsigned int s) const
  {
    if constexpr (dim == 2)
      return corner(s, 1)[0] - corner(s, 0)[0];
    else
      return 0.5 * twice_area({{corner(s, 0), corner(s, 1), corner(s, 2)}});
  }


  template <int dim>
  const PlaneMotion<dim> &
  MortarSegments<dim>::motion(const unsigned int s, const unsigned int k) const
  {
    return corner_motion[corner_index(s, k)];
  }


  template <int dim>
  PairVector<dim>
  MortarSegments<dim>::area_motion(const unsigned int s) const
  {
    PairVector<dim> result = {};
    if constexpr (dim == 2)
      {
        add(1., motion(s, 1)[0], result);
        add(-1., motion(s, 0)[0], result);
      }
    else
      {
        std::array<PlanePoint<dim>, 3> d;
        twice_area({{corner(s, 0), corner(s, 1), corner(s, 2)}}, &d);
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int c = 0; c < 2; ++c)
            add(0.5 * d[k][c], motion(s, k)[c], result);
      }
    return result;
  }


  template <int dim>
  void
  MortarSegments<dim>::compute_motion(const SecondaryFrame<dim>   &frame,
                                      const ProjectedPrimary<dim> &primary,
                                      const VertexMotion<dim>     &vertices)
  {
    motion_known        = true;
    const auto position = [&](const Side side, const unsigned int vertex) {
      return (side == Side::secondary) ? frame.y[vertex] : primary.y[vertex];
    };
    const auto motion_of =
      [&](const Side         side,
          const unsigned int vertex) -> const PlaneMotion<dim> & {
      return vertices.dy[static_cast<unsigned int>(side)][vertex];
    };

    // Step 1: the overlap's vertices.
    for (unsigned int k = 0; k < overlap.n_vertices; ++k)
      {
        const OverlapVertex<dim> &v  = overlap.vertices[k];
        PlaneMotion<dim>         &dv = corner_motion[k];
        if (!v.is_crossing)
          {
            dv = motion_of(v.origin.side, v.origin.vertex);
            continue;
          }
        if constexpr (dim == 3)
          {
            // The crossing stays on both lines. With the motion p_e, p_f of the
            // material points of the lines e and f that are there now, it is
            // p_e + e (m . (p_f - p_e)) / (m . e), m across f.
            const auto line = [&](const FacetLine &l, PlaneMotion<dim> &p) {
              const PlanePoint<dim> from = position(l.side, l.from);
              const PlanePoint<dim> e    = position(l.side, l.to) - from;
              const double          t    = (v.y - from) * e / e.norm_square();
              p                          = {};
              for (unsigned int c = 0; c < 2; ++c)
                {
                  add(1. - t, motion_of(l.side, l.from)[c], p[c]);
                  add(t, motion_of(l.side, l.to)[c], p[c]);
                }
              return e;
            };
            PlaneMotion<dim>      p_f;
            const PlanePoint<dim> e   = line(v.first, dv);
            const PlanePoint<dim> f   = line(v.second, p_f);
            const PlanePoint<dim> m   = cross_product_2d(f);
            const double          m_e = m * e;
            if (std::abs(m_e) > parallel * e.norm() * f.norm())
              {
                PairVector<dim> along = {};
                for (unsigned int c = 0; c < 2; ++c)
                  {
                    add(m[c] / m_e, p_f[c], along);
                    add(-m[c] / m_e, dv[c], along);
                  }
                for (unsigned int c = 0; c < 2; ++c)
                  add(e[c], along, dv[c]);
              }
          }
      }

    // Step 2: the area centroid, sum_k a_k m_k / sum_k a_k over the triangles
    // of a fan with areas a_k and centres m_k.
    if constexpr (dim == 3)
      {
        double                                              sum       = 0.;
        std::array<Tensor<2, 2>, max_overlap_vertices<dim>> by_vertex = {};
        for (unsigned int k = 1; k + 1 < overlap.n_vertices; ++k)
          {
            const std::array<unsigned int, 3>    v = {{0, k, k + 1}};
            const std::array<PlanePoint<dim>, 3> y = {
              {overlap.vertices[v[0]].y,
               overlap.vertices[v[1]].y,
               overlap.vertices[v[2]].y}};
            std::array<PlanePoint<dim>, 3> da;
            const double                   a = twice_area(y, &da);
            sum += a;
            const PlanePoint<dim> off = (y[0] + y[1] + y[2]) / 3. - centroid;
            for (unsigned int j = 0; j < 3; ++j)
              {
                by_vertex[v[j]] += outer_product(off, da[j]);
                for (unsigned int c = 0; c < 2; ++c)
                  by_vertex[v[j]][c][c] += a / 3.;
              }
          }
        PlaneMotion<dim> &dv = corner_motion[max_corners - 1];
        dv                   = {};
        for (unsigned int k = 0; k < overlap.n_vertices; ++k)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int j = 0; j < 2; ++j)
              add(by_vertex[k][c][j] / sum, corner_motion[k][j], dv[c]);
      }
  }


  template struct ProjectedPrimary<2>;
  template struct ProjectedPrimary<3>;
  template struct VertexMotion<2>;
  template struct VertexMotion<3>;
  template class MortarSegments<2>;
  template class MortarSegments<3>;
} // namespace MortarContact
