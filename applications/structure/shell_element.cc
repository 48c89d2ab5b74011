// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_element.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Structure
{
  namespace
  {
    /// Shear correction factor.
    constexpr double shear_correction = 5. / 6.;

    /// Stiffness across the thickness over E: directors keep their length also
    /// in sharp folds (1 lets them collapse to 0.4 there); no effect on
    /// bending.
    constexpr double thickness_stiffness = 10.;

    /// Warped or skew shapes beyond this (1: a triangle) are treated as this.
    constexpr double largest_skew = 0.9;

    /// c (x . y - X . Y), x and y sums of the nodal (r_1.., d_1..).
    struct Term
    {
      double                c;
      std::array<double, 8> x, y;
    };
    using Form = std::vector<Term>;

    struct Point2
    {
      double r, s;
    };

    /// What is the same for all elements with so many nodes. Covariant strains
    /// count 11, 22, 12, 13, 23, 33 with engineering shear.
    struct Table
    {
      unsigned int        n_nodes;
      std::vector<Form>   forms;
      std::vector<Point2> points; ///< Of integration,
      double              weight; ///< all with this weight.
      Point2              middle;
      unsigned int        first_shear, first_thickness, first_bending;
    };

    void
    shape(const unsigned int     n,
          const Point2          &p,
          std::array<double, 4> &N,
          std::array<double, 4> &dr,
          std::array<double, 4> &ds)
    {
      if (n == 3)
        {
          N  = {{1. - p.r - p.s, p.r, p.s, 0.}};
          dr = {{-1., 1., 0., 0.}};
          ds = {{-1., 0., 1., 0.}};
          return;
        }
      const double r_of[4] = {-1., 1., -1., 1.}, s_of[4] = {-1., -1., 1., 1.};
      for (unsigned int i = 0; i < 4; ++i)
        {
          N[i]  = 0.25 * (1. + r_of[i] * p.r) * (1. + s_of[i] * p.s);
          dr[i] = 0.25 * r_of[i] * (1. + s_of[i] * p.s);
          ds[i] = 0.25 * s_of[i] * (1. + r_of[i] * p.r);
        }
    }

    Table
    make_table(const unsigned int n)
    {
      Table table;
      table.n_nodes = n;
      enum What
      {
        value,
        by_r,
        by_s
      };
      // of the middle surface (first half) or the directors (second half)
      const auto sum =
        [n](const Point2 &p, const What what, const bool of_directors) {
          std::array<double, 4> N, dr, ds;
          shape(n, p, N, dr, ds);
          std::array<double, 8> c = {};
          for (unsigned int i = 0; i < n; ++i)
            c[i + (of_directors ? n : 0)] = (what == value) ? N[i] :
                                            (what == by_r)  ? dr[i] :
                                                              ds[i];
          return c;
        };
      const auto membrane = [&](const Point2 &p, const What a, const What b) {
        table.forms.push_back(
          {{(a == b) ? 0.5 : 1., sum(p, a, false), sum(p, b, false)}});
      };
      const auto shear = [&](const Point2 &p, const What a) {
        table.forms.push_back({{1., sum(p, a, false), sum(p, value, true)}});
      };

      if (n == 4)
        {
          const double g = 1. / std::sqrt(3.);
          table.points   = {{-g, -g}, {g, -g}, {-g, g}, {g, g}};
          table.weight   = 1.;
          table.middle   = {0., 0.};
          membrane({0., 1.}, by_r, by_r);
          membrane({0., -1.}, by_r, by_r);
          membrane({1., 0.}, by_s, by_s);
          membrane({-1., 0.}, by_s, by_s);
          membrane({0., 0.}, by_r, by_s);
          table.first_shear = table.forms.size();
          shear({0., 1.}, by_r);
          shear({0., -1.}, by_r);
          shear({1., 0.}, by_s);
          shear({-1., 0.}, by_s);
        }
      else
        {
          table.points = {{1. / 6., 1. / 6.},
                          {2. / 3., 1. / 6.},
                          {1. / 6., 2. / 3.}};
          table.weight = 1. / 6.;
          table.middle = {1. / 3., 1. / 3.};
          membrane(table.middle, by_r, by_r);
          membrane(table.middle, by_s, by_s);
          membrane(table.middle, by_r, by_s);
          table.first_shear = table.forms.size();
          shear({0.5, 0.}, by_r);
          shear({0., 0.5}, by_s);
          shear({0.5, 0.5}, by_r);
          shear({0.5, 0.5}, by_s);
        }

      table.first_thickness = table.forms.size();
      for (unsigned int i = 0; i < n; ++i)
        {
          std::array<double, 8> c = {};
          c[n + i]                = 1.;
          table.forms.push_back({{0.5, c, c}});
        }

      table.first_bending = table.forms.size();
      for (const Point2 &p : table.points)
        {
          const auto rr = sum(p, by_r, false), rs = sum(p, by_s, false);
          const auto dr = sum(p, by_r, true), ds = sum(p, by_s, true);
          table.forms.push_back({{1., rr, dr}});
          table.forms.push_back({{1., rs, ds}});
          table.forms.push_back({{1., rr, ds}, {1., rs, dr}});
        }
      return table;
    }

    const Table &
    table_of(const unsigned int n_nodes)
    {
      static const Table quadrilateral = make_table(4),
                         triangle      = make_table(3);
      return (n_nodes == 4) ? quadrilateral : triangle;
    }

    Tensor<1, 3>
    combine(const std::array<double, 8> &c, const std::vector<Tensor<1, 3>> &z)
    {
      Tensor<1, 3> x;
      for (unsigned int k = 0; k < z.size(); ++k)
        x += c[k] * z[k];
      return x;
    }

    /// Basis at a point of the undeformed shell; the first Cartesian axis lies
    /// in the tangent plane, as near as may be to a given direction.
    struct Basis
    {
      Tensor<1, 3>                         G[3];
      double                               jacobian;  ///< |G_1 x G_2 . G_3|
      double                               area;      ///< |G_1 x G_2|
      std::array<std::array<double, 6>, 6> cartesian; ///< From covariant.
    };

    Basis
    basis_at(const Point2                    &p,
             const std::vector<Tensor<1, 3>> &R,
             const std::vector<Tensor<1, 3>> &D,
             const Tensor<1, 3>              &along)
    {
      std::array<double, 4> N, dr, ds;
      shape(R.size(), p, N, dr, ds);
      Basis b;
      for (unsigned int i = 0; i < R.size(); ++i)
        {
          b.G[0] += dr[i] * R[i];
          b.G[1] += ds[i] * R[i];
          b.G[2] += N[i] * D[i];
        }
      const Tensor<1, 3> normal = cross_product_3d(b.G[0], b.G[1]);
      b.area                    = normal.norm();
      const double volume       = normal * b.G[2];
      b.jacobian                = std::abs(volume);
      AssertThrow(b.area > 1e-12 * b.G[0].norm() * b.G[1].norm() &&
                    b.jacobian > 1e-6 * b.area,
                  ExcMessage("a shell element has no area, or its director "
                             "lies in its plane"));
      // contravariant basis and Cartesian axes
      const Tensor<1, 3> dual[3] = {cross_product_3d(b.G[1], b.G[2]) / volume,
                                    cross_product_3d(b.G[2], b.G[0]) / volume,
                                    normal / volume};
      Tensor<1, 3>       e[3];
      e[2] = normal / b.area;
      // the same axes all over a flat element: what is added to the strains at
      // different points must be in one frame
      e[0] = along - (along * e[2]) * e[2];
      e[0] /= e[0].norm();
      e[1] = cross_product_3d(e[2], e[0]);
      double g[3][3];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int a = 0; a < 3; ++a)
          g[i][a] = dual[i] * e[a];
      const unsigned int pairs[6][2] = {
        {0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}, {2, 2}};
      for (unsigned int row = 0; row < 6; ++row)
        for (unsigned int col = 0; col < 6; ++col)
          {
            const auto [a, c]     = pairs[row];
            const auto [i, j]     = pairs[col];
            b.cartesian[row][col] = (a == c ? 1. : 2.) * 0.5 *
                                    (g[i][a] * g[j][c] + g[j][a] * g[i][c]);
          }
      return b;
    }

    /// Covariant strains without bending at a point by forms: S(6, n_forms).
    FullMatrix<double>
    strains_at(const Point2                    &p,
               const Table                     &table,
               const std::vector<Tensor<1, 3>> &R)
    {
      FullMatrix<double> S(6, table.forms.size());
      const double       r = p.r, s = p.s;
      const unsigned int shear = table.first_shear;
      if (table.n_nodes == 3)
        {
          for (unsigned int i = 0; i < 3; ++i)
            S(i, i) = 1.;
          // MITC3: constant along each edge
          S(3, shear)     = 1. - s;
          S(3, shear + 2) = s;
          S(3, shear + 3) = -s;
          S(3, shear + 1) = s;
          S(4, shear + 1) = 1. - r;
          S(4, shear + 3) = r;
          S(4, shear + 2) = -r;
          S(4, shear)     = r;
        }
      else
        {
          // how far the shape is from a parallelogram, in its plane
          const auto along = [&](const std::array<double, 4> &sign) {
            Tensor<1, 3> x;
            for (unsigned int i = 0; i < 4; ++i)
              x += 0.25 * sign[i] * R[i];
            return x;
          };
          const Tensor<1, 3> x_r = along({{-1., 1., -1., 1.}}),
                             x_s = along({{-1., -1., 1., 1.}}),
                             x_d = along({{1., -1., -1., 1.}});
          const double rr = x_r * x_r, ss = x_s * x_s, rs = x_r * x_s;
          const double det  = rr * ss - rs * rs;
          double       c_r  = (ss * (x_d * x_r) - rs * (x_d * x_s)) / det;
          double       c_s  = (rr * (x_d * x_s) - rs * (x_d * x_r)) / det;
          const double skew = std::abs(c_r) + std::abs(c_s);
          if (skew > largest_skew)
            {
              c_r *= largest_skew / skew;
              c_s *= largest_skew / skew;
            }
          const double d   = c_r * c_r + c_s * c_s - 1.;
          const double a_A = c_r * (c_r - 1.) / (2. * d),
                       a_B = c_r * (c_r + 1.) / (2. * d),
                       a_C = c_s * (c_s - 1.) / (2. * d),
                       a_D = c_s * (c_s + 1.) / (2. * d),
                       a_E = 2. * c_r * c_s / d;
          const double r2 = r * r - 1., s2 = s * s - 1.;
          S(0, 0)         = 0.5 * (1. + s) + a_A * s2;
          S(0, 1)         = 0.5 * (1. - s) + a_B * s2;
          S(0, 2)         = a_C * s2;
          S(0, 3)         = a_D * s2;
          S(0, 4)         = 0.5 * a_E * s2;
          S(1, 0)         = a_A * r2;
          S(1, 1)         = a_B * r2;
          S(1, 2)         = 0.5 * (1. + r) + a_C * r2;
          S(1, 3)         = 0.5 * (1. - r) + a_D * r2;
          S(1, 4)         = 0.5 * a_E * r2;
          S(2, 0)         = 0.5 * r + 2. * a_A * r * s;
          S(2, 1)         = -0.5 * r + 2. * a_B * r * s;
          S(2, 2)         = 0.5 * s + 2. * a_C * r * s;
          S(2, 3)         = -0.5 * s + 2. * a_D * r * s;
          S(2, 4)         = 1. + a_E * r * s;
          S(3, shear)     = 0.5 * (1. + s);
          S(3, shear + 1) = 0.5 * (1. - s);
          S(4, shear + 2) = 0.5 * (1. + r);
          S(4, shear + 3) = 0.5 * (1. - r);
        }
      std::array<double, 4> N, dr, ds;
      shape(table.n_nodes, p, N, dr, ds);
      for (unsigned int i = 0; i < table.n_nodes; ++i)
        S(5, table.first_thickness + i) = N[i];
      return S;
    }

    /// Cartesian strains by forms, without bending.
    FullMatrix<double>
    cartesian(const Basis &b, const FullMatrix<double> &S)
    {
      FullMatrix<double> A(6, S.n());
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int k = 0; k < 6; ++k)
          for (unsigned int f = 0; f < S.n(); ++f)
            A(i, f) += b.cartesian[i][k] * S(k, f);
      return A;
    }

    /// Cartesian bending strains by forms, at integration point @p q.
    FullMatrix<double>
    bending(const Basis &b, const Table &table, const unsigned int q)
    {
      FullMatrix<double> A(3, table.forms.size());
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          A(i, table.first_bending + 3 * q + k) = b.cartesian[i][k];
      return A;
    }

    /// sum += factor A^T C B
    void
    add_product(const double              factor,
                const FullMatrix<double> &A,
                const FullMatrix<double> &C,
                const FullMatrix<double> &B,
                FullMatrix<double>       &sum)
    {
      FullMatrix<double> CB(C.m(), B.n());
      C.mmult(CB, B);
      CB *= factor;
      A.Tmmult(sum, CB, true);
    }

    /// forces = B^T S
    void
    forces_of(const FullMatrix<double>  &B,
              const std::vector<double> &S,
              Vector<double>            &forces)
    {
      forces = 0.;
      for (unsigned int i = 0; i < B.m(); ++i)
        for (unsigned int a = 0; a < B.n(); ++a)
          forces(a) += B(i, a) * S[i];
    }
  } // namespace


  ShellElement::ShellElement(const std::vector<Vec> &R,
                             const std::vector<Vec> &D,
                             const ShellSection     &section,
                             const double            director_scale)
    : R(R)
    , D(D)
    , section(section)
    , scale(director_scale)
  {
    const Table       &table = table_of(R.size());
    const unsigned int n     = table.forms.size();
    at_rest                  = R;
    at_rest.insert(at_rest.end(), D.begin(), D.end());

    // the law
    const double       E = section.youngs_modulus, nu = section.poissons_ratio;
    const double       t = section.thickness, G = E / (2. * (1. + nu));
    FullMatrix<double> plane(3, 3), law(6, 6);
    plane(0, 0) = plane(1, 1) = E / (1. - nu * nu);
    plane(0, 1) = plane(1, 0) = nu * plane(0, 0);
    plane(2, 2)               = G;
    const bool has_layers     = section.has_layers();
    if (!has_layers)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          law(i, j) = plane(i, j);
    law(3, 3) = law(4, 4) = shear_correction * G;
    law(5, 5)             = thickness_stiffness * E;

    // Step 1: the quadratic form of the tied strains.
    const bool         is_quad = R.size() == 4;
    const Basis        middle  = basis_at(table.middle, R, D, R[1] - R[0]);
    const unsigned int n_modes = is_quad ? 4 : 0;
    of_modes.reinit(n_modes, n_modes);
    mixed.reinit(n, n_modes);
    Q.reinit(n, n);
    shape_products.reinit(R.size(), R.size());
    for (unsigned int q = 0; q < table.points.size(); ++q)
      {
        const Point2 &p = table.points[q];
        const Basis   b = basis_at(p, R, D, R[1] - R[0]);
        const double  w = table.weight * b.jacobian;
        const auto    A = cartesian(b, strains_at(p, table, R));
        const auto    B = bending(b, table, q);
        add_product(w * t, A, law, A, Q);
        if (!has_layers)
          add_product(w * t * t * t / 12., B, plane, B, Q);

        std::array<double, 4> N, dr, ds;
        shape(R.size(), p, N, dr, ds);
        for (unsigned int i = 0; i < R.size(); ++i)
          for (unsigned int j = 0; j < R.size(); ++j)
            shape_products(i, j) += table.weight * b.area * N[i] * N[j];

        // modes r in 11, s in 22, r and s in 12
        FullMatrix<double> M(6, n_modes);
        const double       along[4]  = {p.r, p.s, p.r, p.s};
        const unsigned int strain[4] = {0, 1, 2, 2};
        for (unsigned int m = 0; m < n_modes; ++m)
          for (unsigned int i = 0; i < 6; ++i)
            M(i, m) = middle.jacobian / b.jacobian *
                      middle.cartesian[i][strain[m]] * along[m];
        if (is_quad)
          {
            add_product(w * t, M, law, M, of_modes);
            add_product(w * t, A, law, M, mixed);
          }
        if (has_layers)
          {
            // strains in the plane come from the forms of the membrane and
            // from the three of bending at this point
            LayeredPoint point;
            point.weight = w;
            point.A.reinit(3, table.first_shear);
            point.M.reinit(3, n_modes);
            point.B.reinit(3, 3);
            for (unsigned int i = 0; i < 3; ++i)
              {
                for (unsigned int f = 0; f < table.first_shear; ++f)
                  point.A(i, f) = A(i, f);
                for (unsigned int m = 0; m < n_modes; ++m)
                  point.M(i, m) = M(i, m);
                for (unsigned int k = 0; k < 3; ++k)
                  point.B(i, k) = b.cartesian[i][k];
              }
            layered.push_back(point);
          }
      }
    if (has_layers)
      {
        const QGauss<1> rule(section.n_layers);
        for (unsigned int l = 0; l < rule.size(); ++l)
          layers.push_back({{2. * rule.point(l)[0] - 1., rule.weight(l)}});
        if (section.hardening.yield_stress > 0.)
          states.resize(layered.size() * layers.size());
        modes.resize(n_modes, 0.);
      }

    // Step 2: the modes, condensed.
    if (is_quad && !has_layers)
      {
        FullMatrix<double> inverse(4, 4), product(4, n), transposed(4, n);
        inverse.invert(of_modes);
        transposed.copy_transposed(mixed);
        inverse.mmult(product, transposed);
        product *= -1.;
        mixed.mmult(Q, product, true);
      }
    Q.symmetrize();

    // Step 3: strains in the middle, for output.
    const auto A = cartesian(middle, strains_at(table.middle, table, R));
    membrane_at_middle.reinit(3, n);
    bending_at_middle.reinit(3, n);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int f = 0; f < n; ++f)
        {
          membrane_at_middle(i, f) = A(i, f);
          for (unsigned int q = 0; q < table.points.size(); ++q)
            bending_at_middle(i, f) +=
              bending(middle, table, q)(i, f) / table.points.size();
        }
  }


  std::vector<double>
  ShellElement::values(const std::vector<Vec> &dz) const
  {
    // c (x.y - X.Y) by differences: free of cancellation for small motions
    const Table        &table = table_of(R.size());
    std::vector<double> f(table.forms.size(), 0.);
    for (unsigned int i = 0; i < f.size(); ++i)
      for (const Term &term : table.forms[i])
        {
          const Vec dx = combine(term.x, dz), dy = combine(term.y, dz);
          f[i] += term.c * (combine(term.x, at_rest) * dy +
                            dx * combine(term.y, at_rest) + dx * dy);
        }
    return f;
  }


  std::vector<Tensor<1, 3>>
  ShellElement::motion(const Vector<double> &u) const
  {
    const unsigned int n = R.size();
    std::vector<Vec>   dz(2 * n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          dz[i][c]     = u(6 * i + c);
          dz[n + i][c] = u(6 * i + 3 + c) / scale;
        }
    return dz;
  }


  bool
  ShellElement::respond(const std::vector<double> &f,
                        const bool                 with_tangent,
                        std::vector<double>       &S,
                        FullMatrix<double>        &D,
                        std::vector<PlasticState> &now,
                        std::vector<double>       &alpha,
                        double                    &energy) const
  {
    const Table       &table = table_of(R.size());
    const unsigned int n = f.size(), n_m = of_modes.m();
    const unsigned int n_membrane = table.first_shear;
    const double       t          = section.thickness;
    const PlasticState untouched;
    now   = states;
    alpha = modes;

    // strains, and what they depend on: forms, modes
    const auto strain_at = [&](const unsigned int         q,
                               const double               z,
                               const std::vector<double> &alpha) {
      const LayeredPoint &p = layered[q];
      PlaneVector         e = {};
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (unsigned int k = 0; k < n_membrane; ++k)
            e[i] += p.A(i, k) * f[k];
          for (unsigned int m = 0; m < n_m; ++m)
            e[i] += p.M(i, m) * alpha[m];
          for (unsigned int k = 0; k < 3; ++k)
            e[i] += z * p.B(i, k) * f[table.first_bending + 3 * q + k];
        }
      return e;
    };

    // Step 1: the modes, that their stresses vanish: the minimum of a convex
    // function, by Newton's method with a line search.
    std::vector<PlaneResponse> points(layered.size() * layers.size());
    FullMatrix<double>         K(n_m, n_m);
    Vector<double>             r(n_m), step(n_m);
    double                     size     = 0.; ///< Of what adds up to r,
    double                     noise    = 0.; ///< and of its round-off.
    bool                       is_valid = true;
    const auto                 evaluate = [&]() {
      K        = of_modes;
      size     = 0.;
      noise    = 0.;
      is_valid = true;
      for (unsigned int m = 0; m < n_m; ++m)
        {
          r(m) = 0.;
          for (unsigned int k = 0; k < n_m; ++k)
            r(m) += of_modes(m, k) * alpha[k];
          for (unsigned int k = 0; k < n; ++k)
            r(m) += mixed(k, m) * f[k];
        }
      for (unsigned int q = 0; q < layered.size(); ++q)
        for (unsigned int l = 0; l < layers.size(); ++l)
          {
            const unsigned int i = q * layers.size() + l;
            const double       w = layered[q].weight * t * layers[l][1];
            points[i] =
              evaluate_plane_stress(section,
                                    strain_at(q, 0.5 * t * layers[l][0], alpha),
                                    states.empty() ? untouched : states[i]);
            is_valid = is_valid && points[i].is_valid;
            if (!states.empty())
              now[i] = points[i].state;
            for (unsigned int m = 0; m < n_m; ++m)
              for (unsigned int a = 0; a < 3; ++a)
                {
                  const double g = w * layered[q].M(a, m);
                  r(m) += g * points[i].stress[a];
                  size += std::abs(g * points[i].stress[a]);
                  noise += std::abs(g) * section.youngs_modulus;
                  for (unsigned int k = 0; k < n_m; ++k)
                    for (unsigned int b = 0; b < 3; ++b)
                      K(m, k) +=
                        g * points[i].tangent[a][b] * layered[q].M(b, k);
                }
          }
    };
    evaluate();
    if (!is_valid)
      return false;
    bool converged = n_m == 0;
    for (unsigned int iteration = 0; iteration < 50 && !converged; ++iteration)
      {
        K.gauss_jordan();
        if (r.l2_norm() <= 1e-13 * size + 1e-15 * noise)
          {
            converged = true;
            break;
          }
        K.vmult(step, r);
        const std::vector<double> from  = alpha;
        const double              slope = step * r;
        double                    share = 1.;
        for (unsigned int trial = 0; trial < 8; ++trial, share *= 0.5)
          {
            for (unsigned int m = 0; m < n_m; ++m)
              alpha[m] = from[m] - share * step(m);
            evaluate();
            if (is_valid && std::abs(step * r) <= 0.8 * std::abs(slope))
              break;
          }
        if (!is_valid)
          return false;
        // nothing changes any more
        converged = std::equal(from.begin(), from.end(), alpha.begin());
        if (converged)
          K.gauss_jordan();
      }
    if (!converged)
      return false;

    // Step 2: stresses of the forms. K is the inverse of the modes' stiffness.
    energy = 0.;
    D      = Q;
    for (unsigned int i = 0; i < n; ++i)
      {
        S[i] = 0.;
        for (unsigned int j = 0; j < n; ++j)
          {
            S[i] += Q(i, j) * f[j];
            energy += 0.5 * f[i] * Q(i, j) * f[j];
          }
        for (unsigned int m = 0; m < n_m; ++m)
          {
            S[i] += mixed(i, m) * alpha[m];
            energy += mixed(i, m) * f[i] * alpha[m];
          }
      }
    for (unsigned int m = 0; m < n_m; ++m)
      for (unsigned int k = 0; k < n_m; ++k)
        energy += 0.5 * of_modes(m, k) * alpha[m] * alpha[k];
    FullMatrix<double>        coupling = mixed; // (form, mode)
    std::vector<unsigned int> form(n_membrane + 3);
    FullMatrix<double>        E(3, n_membrane + 3);
    for (unsigned int q = 0; q < layered.size(); ++q)
      for (unsigned int l = 0; l < layers.size(); ++l)
        {
          const PlaneResponse &p = points[q * layers.size() + l];
          const double         w = layered[q].weight * t * layers[l][1];
          const double         z = 0.5 * t * layers[l][0];
          energy += w * p.energy;
          for (unsigned int c = 0; c < form.size(); ++c)
            {
              const bool is_bending = c >= n_membrane;
              form[c] =
                is_bending ? table.first_bending + 3 * q + c - n_membrane : c;
              for (unsigned int a = 0; a < 3; ++a)
                E(a, c) = is_bending ? z * layered[q].B(a, c - n_membrane) :
                                       layered[q].A(a, c);
            }
          for (unsigned int c = 0; c < form.size(); ++c)
            for (unsigned int a = 0; a < 3; ++a)
              {
                if (E(a, c) == 0.)
                  continue;
                const double g = w * E(a, c);
                S[form[c]] += g * p.stress[a];
                if (!with_tangent)
                  continue;
                double row[3];
                for (unsigned int b = 0; b < 3; ++b)
                  row[b] = g * p.tangent[a][b];
                for (unsigned int d = 0; d < form.size(); ++d)
                  for (unsigned int b = 0; b < 3; ++b)
                    D(form[c], form[d]) += row[b] * E(b, d);
                for (unsigned int m = 0; m < n_m; ++m)
                  for (unsigned int b = 0; b < 3; ++b)
                    coupling(form[c], m) += row[b] * layered[q].M(b, m);
              }
        }
    if (with_tangent && n_m > 0)
      {
        FullMatrix<double> KC(n_m, n), transposed(n_m, n);
        transposed.copy_transposed(coupling);
        K.mmult(KC, transposed);
        KC *= -1.;
        coupling.mmult(D, KC, true);
      }
    return true;
  }


  FullMatrix<double>
  ShellElement::derivatives(const std::vector<Vec> &z) const
  {
    const Table       &table = table_of(R.size());
    const unsigned int n     = R.size();
    FullMatrix<double> B(table.forms.size(), 6 * n);
    for (unsigned int i = 0; i < B.m(); ++i)
      for (const Term &term : table.forms[i])
        {
          const Vec x = combine(term.x, z), y = combine(term.y, z);
          for (unsigned int k = 0; k < 2 * n; ++k)
            {
              const double factor = (k < n) ? term.c : term.c / scale;
              for (unsigned int c = 0; c < 3; ++c)
                B(i, dof(k, c)) +=
                  factor * (term.x[k] * y[c] + term.y[k] * x[c]);
            }
        }
    return B;
  }


  void
  ShellElement::extrapolate(const Vector<double>     &u,
                            const Vector<double>     &previous,
                            const FullMatrix<double> &C,
                            const double              factor,
                            std::vector<double>      &S) const
  {
    const Table   &table      = table_of(R.size());
    Vector<double> difference = u;
    difference -= previous;
    const std::vector<Vec> step = motion(difference);
    std::vector<double>    quadratic(S.size(), 0.);
    for (unsigned int i = 0; i < S.size(); ++i)
      for (const Term &term : table.forms[i])
        quadratic[i] +=
          term.c * (combine(term.x, step) * combine(term.y, step));
    for (unsigned int i = 0; i < S.size(); ++i)
      for (unsigned int j = 0; j < S.size(); ++j)
        S[i] -= factor * C(i, j) * quadratic[j];
  }


  void
  ShellElement::add_geometric(const std::vector<double> &S,
                              FullMatrix<double>        &tangent) const
  {
    const Table       &table           = table_of(R.size());
    const unsigned int n               = R.size();
    double             geometric[8][8] = {};
    for (unsigned int i = 0; i < S.size(); ++i)
      for (const Term &term : table.forms[i])
        for (unsigned int k = 0; k < 2 * n; ++k)
          if (term.x[k] != 0.)
            for (unsigned int l = 0; l < 2 * n; ++l)
              {
                const double g = S[i] * term.c * term.x[k] * term.y[l];
                geometric[k][l] += g;
                geometric[l][k] += g;
              }
    for (unsigned int k = 0; k < 2 * n; ++k)
      for (unsigned int l = 0; l < 2 * n; ++l)
        for (unsigned int c = 0; c < 3; ++c)
          tangent(dof(k, c), dof(l, c)) +=
            geometric[k][l] / ((k < n ? 1. : scale) * (l < n ? 1. : scale));
  }


  bool
  ShellElement::evaluate(const Vector<double> &u,
                         const bool            with_tangent,
                         const Vector<double> *previous,
                         Vector<double>       &forces,
                         FullMatrix<double>   &tangent) const
  {
    const unsigned int     n_forms = table_of(R.size()).forms.size();
    const std::vector<Vec> dz      = motion(u);
    std::vector<Vec>       z       = at_rest;
    for (unsigned int k = 0; k < z.size(); ++k)
      z[k] += dz[k];

    // Step 1: stresses of the forms, and the forms' derivatives.
    const std::vector<double> f = values(dz);
    std::vector<double>       S(n_forms, 0.);
    FullMatrix<double>        of_forms;
    const bool                has_layers = !layered.empty();
    double                    energy     = 0.;
    if (has_layers)
      {
        if (!respond(f, with_tangent, S, of_forms, trial, trial_modes, energy))
          return false;
      }
    else
      for (unsigned int i = 0; i < n_forms; ++i)
        for (unsigned int j = 0; j < n_forms; ++j)
          S[i] += Q(i, j) * f[j];
    const FullMatrix<double> &C = has_layers ? of_forms : Q; // dS/df
    const FullMatrix<double>  B = derivatives(z);
    forces_of(B, S, forces);
    if (!with_tangent)
      return true;

    // Step 2: the tangent.
    if (previous != nullptr)
      extrapolate(u, *previous, C, 1., S);
    FullMatrix<double> CB(n_forms, B.n());
    C.mmult(CB, B);
    B.Tmmult(tangent, CB);
    add_geometric(S, tangent);
    return true;
  }


  void
  ShellElement::evaluate_step(const Vector<double> &u_n,
                              const Vector<double> &u,
                              const bool            with_tangent,
                              const Vector<double> *previous,
                              Vector<double>       &forces,
                              FullMatrix<double>   &tangent) const
  {
    Assert(layered.empty(), ExcNotImplemented());
    const unsigned int     n_forms = table_of(R.size()).forms.size();
    const std::vector<Vec> dz_n = motion(u_n), dz = motion(u);
    std::vector<Vec>       z_mean = at_rest, z = at_rest;
    for (unsigned int k = 0; k < z.size(); ++k)
      {
        z_mean[k] += 0.5 * (dz_n[k] + dz[k]);
        z[k] += dz[k];
      }

    const std::vector<double> f_n = values(dz_n), f = values(dz);
    std::vector<double>       S(n_forms, 0.);
    for (unsigned int i = 0; i < n_forms; ++i)
      for (unsigned int j = 0; j < n_forms; ++j)
        S[i] += 0.5 * Q(i, j) * (f_n[j] + f[j]);
    const FullMatrix<double> B_mean = derivatives(z_mean);
    forces_of(B_mean, S, forces);
    if (!with_tangent)
      return;

    if (previous != nullptr)
      extrapolate(u, *previous, Q, 0.5, S);
    FullMatrix<double> QB(n_forms, B_mean.n());
    Q.mmult(QB, derivatives(z));
    B_mean.Tmmult(tangent, QB);
    add_geometric(S, tangent);
    tangent *= 0.5;
  }


  double
  ShellElement::energy(const Vector<double> &u) const
  {
    const std::vector<double> f = values(motion(u));
    if (!layered.empty())
      {
        std::vector<double>       S(f.size()), alpha;
        FullMatrix<double>        D;
        std::vector<PlasticState> now;
        double                    energy = 0.;
        return respond(f, false, S, D, now, alpha, energy) ?
                 energy :
                 std::numeric_limits<double>::quiet_NaN();
      }
    double e = 0.;
    for (unsigned int i = 0; i < f.size(); ++i)
      for (unsigned int j = 0; j < f.size(); ++j)
        e += 0.5 * f[i] * Q(i, j) * f[j];
    return e;
  }


  void
  ShellElement::commit()
  {
    if (!trial.empty())
      states = trial;
    if (!trial_modes.empty())
      modes = trial_modes;
  }


  double
  ShellElement::plastic_strain() const
  {
    double largest = 0.;
    for (const PlasticState &state : states)
      largest = std::max(largest, state.equivalent);
    return largest;
  }


  void
  ShellElement::mass(FullMatrix<double> &M) const
  {
    const double t    = section.thickness;
    const double of_v = section.density * t;
    const double of_q = section.density * t * t * t / 12. / (scale * scale);
    M                 = 0.;
    for (unsigned int i = 0; i < R.size(); ++i)
      for (unsigned int j = 0; j < R.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          {
            M(6 * i + c, 6 * j + c)         = of_v * shape_products(i, j);
            M(6 * i + 3 + c, 6 * j + 3 + c) = of_q * shape_products(i, j);
          }
  }


  PlaneVector
  ShellElement::stress(const Vector<double> &u, const double height) const
  {
    const std::vector<double> f = values(motion(u));
    PlaneVector               e = {};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < f.size(); ++k)
        e[i] +=
          f[k] * (membrane_at_middle(i, k) +
                  0.5 * height * section.thickness * bending_at_middle(i, k));
    // the plastic strains of the layer nearest, in the mean
    PlasticState state;
    if (!states.empty())
      {
        unsigned int nearest = 0;
        for (unsigned int l = 1; l < layers.size(); ++l)
          if (std::abs(layers[l][0] - height) <
              std::abs(layers[nearest][0] - height))
            nearest = l;
        const double share = 1. / layered.size();
        for (unsigned int q = 0; q < layered.size(); ++q)
          {
            const PlasticState &of_point = states[q * layers.size() + nearest];
            for (unsigned int i = 0; i < 3; ++i)
              state.strain[i] += share * of_point.strain[i];
            state.equivalent += share * of_point.equivalent;
          }
      }
    return evaluate_plane_stress(section, e, state).stress;
  }
} // namespace Structure
