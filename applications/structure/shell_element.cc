// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_element.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

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
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        law(i, j) = plane(i, j);
    law(3, 3) = law(4, 4) = shear_correction * G;
    law(5, 5)             = thickness_stiffness * E;

    // Step 1: the quadratic form of the tied strains.
    const bool         is_quad = R.size() == 4;
    const Basis        middle  = basis_at(table.middle, R, D, R[1] - R[0]);
    const unsigned int n_modes = is_quad ? 4 : 0;
    FullMatrix<double> of_modes(n_modes, n_modes), mixed(n, n_modes);
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
        add_product(w * t * t * t / 12., B, plane, B, Q);

        std::array<double, 4> N, dr, ds;
        shape(R.size(), p, N, dr, ds);
        for (unsigned int i = 0; i < R.size(); ++i)
          for (unsigned int j = 0; j < R.size(); ++j)
            shape_products(i, j) += table.weight * b.area * N[i] * N[j];

        if (!is_quad)
          continue;
        // modes r in 11, s in 22, r and s in 12
        FullMatrix<double> M(6, 4);
        const double       along[4]  = {p.r, p.s, p.r, p.s};
        const unsigned int strain[4] = {0, 1, 2, 2};
        for (unsigned int m = 0; m < 4; ++m)
          for (unsigned int i = 0; i < 6; ++i)
            M(i, m) = middle.jacobian / b.jacobian *
                      middle.cartesian[i][strain[m]] * along[m];
        add_product(w * t, M, law, M, of_modes);
        add_product(w * t, A, law, M, mixed);
      }

    // Step 2: the modes, condensed.
    if (is_quad)
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


  void
  ShellElement::evaluate(const Vector<double> &u,
                         const bool            with_tangent,
                         const Vector<double> *previous,
                         Vector<double>       &forces,
                         FullMatrix<double>   &tangent) const
  {
    const Table           &table   = table_of(R.size());
    const unsigned int     n       = R.size();
    const unsigned int     n_forms = table.forms.size();
    const std::vector<Vec> dz      = motion(u);
    std::vector<Vec>       z       = at_rest;
    for (unsigned int k = 0; k < 2 * n; ++k)
      z[k] += dz[k];

    // Step 1: stresses of the forms, and the forms' derivatives.
    const std::vector<double> f = values(dz);
    std::vector<double>       S(n_forms, 0.);
    for (unsigned int i = 0; i < n_forms; ++i)
      for (unsigned int j = 0; j < n_forms; ++j)
        S[i] += Q(i, j) * f[j];
    // B(form, dof), dofs in the element's order
    const auto dof = [n](const unsigned int k, const unsigned int c) {
      return (k < n) ? 6 * k + c : 6 * (k - n) + 3 + c;
    };
    FullMatrix<double> B(n_forms, 6 * n);
    for (unsigned int i = 0; i < n_forms; ++i)
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
    forces = 0.;
    for (unsigned int i = 0; i < n_forms; ++i)
      for (unsigned int a = 0; a < 6 * n; ++a)
        forces(a) += B(i, a) * S[i];
    if (!with_tangent)
      return;

    // Step 2: stresses of the geometric part.
    if (previous != nullptr)
      {
        Vector<double> difference = u;
        difference -= *previous;
        const std::vector<Vec> step   = motion(difference);
        std::vector<double>    linear = f;
        for (unsigned int i = 0; i < n_forms; ++i)
          for (const Term &term : table.forms[i])
            linear[i] -=
              term.c * (combine(term.x, step) * combine(term.y, step));
        for (unsigned int i = 0; i < n_forms; ++i)
          {
            S[i] = 0.;
            for (unsigned int j = 0; j < n_forms; ++j)
              S[i] += Q(i, j) * linear[j];
          }
      }

    // Step 3: the tangent.
    FullMatrix<double> QB(n_forms, 6 * n);
    Q.mmult(QB, B);
    B.Tmmult(tangent, QB);
    double geometric[8][8] = {};
    for (unsigned int i = 0; i < n_forms; ++i)
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


  double
  ShellElement::energy(const Vector<double> &u) const
  {
    const std::vector<double> f = values(motion(u));
    double                    e = 0.;
    for (unsigned int i = 0; i < f.size(); ++i)
      for (unsigned int j = 0; j < f.size(); ++j)
        e += 0.5 * f[i] * Q(i, j) * f[j];
    return e;
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


  std::array<double, 3>
  ShellElement::stress(const Vector<double> &u, const double height) const
  {
    const std::vector<double> f = values(motion(u));
    double                    e[3];
    for (unsigned int i = 0; i < 3; ++i)
      {
        e[i] = 0.;
        for (unsigned int k = 0; k < f.size(); ++k)
          e[i] +=
            f[k] * (membrane_at_middle(i, k) +
                    0.5 * height * section.thickness * bending_at_middle(i, k));
      }
    const double E = section.youngs_modulus, nu = section.poissons_ratio;
    const double c = E / (1. - nu * nu);
    return {{c * (e[0] + nu * e[1]),
             c * (e[1] + nu * e[0]),
             E / (2. * (1. + nu)) * e[2]}};
  }
} // namespace Structure
