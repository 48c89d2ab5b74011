// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_oracle_h
#define mortar_contact_tests_oracle_h

// An independent implementation of the contact of one pair, written from THEORY
// 2.1 to 2.3 with plain arrays and templated on the scalar type, so that
// automatic differentiation gives the exact derivative of the discrete
// residual. Slow and simple on purpose. 3d only; implicit maps are iterated in
// double, then corrected by one more Newton step in the scalar type, which
// makes their derivatives exact.

#include <mortar_contact/geometry/simplex_rule.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace Oracle
{
  template <class T>
  using V3 = std::array<T, 3>;
  template <class T>
  using V2 = std::array<T, 2>;

  template <class T>
  V3<T>
  sub(const V3<T> &a, const V3<T> &b)
  {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
  }

  template <class T>
  T
  dot(const V3<T> &a, const V3<T> &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  template <class T>
  V3<T>
  cross(const V3<T> &a, const V3<T> &b)
  {
    return {{a[1] * b[2] - a[2] * b[1],
             a[2] * b[0] - a[0] * b[2],
             a[0] * b[1] - a[1] * b[0]}};
  }

  inline double
  value(const double x)
  {
    return x;
  }

  template <class T>
  auto
  value(const T &x) -> decltype(value(x.val()))
  {
    return value(x.val());
  }

  /// Shape functions and their derivatives; 3 or 4 vertices in cyclic order.
  template <class T>
  void
  shapes(const unsigned int n,
         const V2<T>       &xi,
         std::array<T, 4>  &N,
         std::array<T, 4>  &N1,
         std::array<T, 4>  &N2)
  {
    const T a = xi[0], b = xi[1];
    if (n == 3)
      {
        N  = {{1. - a - b, a, b, T(0.)}};
        N1 = {{T(-1.), T(1.), T(0.), T(0.)}};
        N2 = {{T(-1.), T(0.), T(1.), T(0.)}};
      }
    else
      {
        N  = {{(1. - a) * (1. - b), a * (1. - b), a * b, (1. - a) * b}};
        N1 = {{b - 1., 1. - b, b, -b}};
        N2 = {{a - 1., -a, a, 1. - a}};
      }
  }

  template <class T>
  struct Facet
  {
    unsigned int          n;
    std::array<V3<T>, 4>  x;
    std::array<double, 4> compliance, length;
  };

  template <class T>
  V3<T>
  sum(const Facet<T> &f, const std::array<T, 4> &w)
  {
    V3<T> x = {{T(0.), T(0.), T(0.)}};
    for (unsigned int a = 0; a < f.n; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        x[i] += w[a] * f.x[a][i];
    return x;
  }

  /// One Newton step of the inverse of the plane bilinear or linear map.
  template <class T>
  void
  newton_step(const unsigned int          n,
              const std::array<V2<T>, 4> &y,
              const V2<T>                &at,
              V2<T>                      &xi)
  {
    std::array<T, 4> N, N1, N2;
    shapes(n, xi, N, N1, N2);
    T r0 = at[0], r1 = at[1], a = T(0.), b = T(0.), c = T(0.), d = T(0.);
    for (unsigned int v = 0; v < n; ++v)
      {
        r0 -= N[v] * y[v][0];
        r1 -= N[v] * y[v][1];
        a += N1[v] * y[v][0];
        b += N2[v] * y[v][0];
        c += N1[v] * y[v][1];
        d += N2[v] * y[v][1];
      }
    const T det = a * d - b * c;
    xi[0] += (d * r0 - b * r1) / det;
    xi[1] += (a * r1 - c * r0) / det;
  }

  /// Inverse of the plane bilinear or linear map.
  template <class T>
  V2<T>
  inverse(const unsigned int n, const std::array<V2<T>, 4> &y, const V2<T> &at)
  {
    std::array<V2<double>, 4> yd = {};
    for (unsigned int v = 0; v < n; ++v)
      yd[v] = {{value(y[v][0]), value(y[v][1])}};
    const V2<double> target = {{value(at[0]), value(at[1])}};
    V2<double>       xi     = {{0.4, 0.4}};
    for (unsigned int i = 0; i < 30; ++i)
      newton_step(n, yd, target, xi);
    V2<T> x = {{T(xi[0]), T(xi[1])}};
    newton_step(n, y, at, x);
    return x;
  }

  template <class T>
  T
  turn(const V2<T> &a, const V2<T> &b, const V2<T> &c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  struct Setup
  {
    std::array<V3<double>, 4> reference; ///< Of the secondary.
    std::array<double, 4>     level = {{0., 0., 0., 0.}};
    double                    share = 0., gap_shift = 0.;
    unsigned int              degree = 5;
    bool                      series = true;
    /// Pressure of penetration, modulus, length, in the scalar type.
    double alpha = 0.1, eps = 0.03, igap = 1.;
  };

  /// Parabola-linear law with the cubic branch, THEORY 1.2 and 1.3.
  template <class T>
  T
  pressure(const Setup &s, const T &d, const T &K, const T &l)
  {
    const T      x  = d / (s.eps * l);
    const double xm = 0.5 / s.eps, xq = 0.25 / s.eps;
    const auto   f0 = [](const T &z) -> T {
      if (value(z) < 2.)
        return z * z / 4.;
      return z - 1.;
    };
    T f = f0(x);
    if (value(x) > xm)
      // beyond the largest penetration: along the tangent
      f = s.igap * (xm - 1.) +
          (1. + 3. * (s.igap - 1.) * (xm - 1.) / (xm - xq)) * (x - xm);
    else if (value(x) > xq)
      {
        const T t = (x - xq) / (xm - xq);
        f += (s.igap - 1.) * f0(T(xm)) * t * t * t;
      }
    return s.alpha * s.eps * K * f;
  }

  /// Residual: 12 secondary, then 12 primary components.
  template <class T>
  std::array<T, 24>
  residual(const Setup &setup, const Facet<T> &s, const Facet<T> &p)
  {
    using std::sqrt;
    std::array<T, 24> f;
    f.fill(T(0.));

    // frame
    V3<T> c = {{T(0.), T(0.), T(0.)}};
    for (unsigned int a = 0; a < s.n; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        c[i] += s.x[a][i] / double(s.n);
    const V3<T> pp = s.n == 3 ? sub(s.x[1], s.x[0]) : sub(s.x[2], s.x[0]);
    const V3<T> qq = s.n == 3 ? sub(s.x[2], s.x[0]) : sub(s.x[3], s.x[1]);
    const V3<T> w  = cross(pp, qq);
    const T     wl = sqrt(dot(w, w));
    const V3<T> n  = {{w[0] / wl, w[1] / wl, w[2] / wl}};
    // any basis will do: e0 from a fixed direction
    V3<T>       e0;
    const V3<T> fixed = {{T(0.31), T(0.87), T(-0.2)}};
    const T     fn    = dot(fixed, n);
    for (unsigned int i = 0; i < 3; ++i)
      e0[i] = fixed[i] - fn * n[i];
    const T e0l = sqrt(dot(e0, e0));
    for (unsigned int i = 0; i < 3; ++i)
      e0[i] /= e0l;
    const V3<T> e1 = cross(n, e0);

    std::array<V2<T>, 4> ys, yp;
    for (unsigned int a = 0; a < s.n; ++a)
      ys[a] = {{dot(sub(s.x[a], c), e0), dot(sub(s.x[a], c), e1)}};
    for (unsigned int a = 0; a < p.n; ++a)
      yp[a] = {{dot(sub(p.x[a], c), e0), dot(sub(p.x[a], c), e1)}};

    // clip: the primary in reversed order by the secondary's edges
    std::vector<V2<T>> poly(yp.begin(), yp.begin() + p.n);
    if (value(turn(yp[0], yp[1], yp[2])) < 0.)
      poly.assign(yp.rend() - p.n, yp.rend());
    for (unsigned int k = 0; k < s.n; ++k)
      {
        const V2<T>        a = ys[k], b = ys[(k + 1) % s.n];
        std::vector<V2<T>> out;
        for (unsigned int i = 0; i < poly.size(); ++i)
          {
            const V2<T> from = poly[i], to = poly[(i + 1) % poly.size()];
            const T     d0 = turn(a, b, from), d1 = turn(a, b, to);
            if (value(d0) >= 0.)
              out.push_back(from);
            if ((value(d0) >= 0.) != (value(d1) >= 0.))
              {
                const T t = d0 / (d0 - d1);
                out.push_back({{from[0] + t * (to[0] - from[0]),
                                from[1] + t * (to[1] - from[1])}});
              }
          }
        poly = out;
      }
    if (poly.size() < 3)
      return f;

    // area centroid
    T     A = T(0.);
    V2<T> m = {{T(0.), T(0.)}};
    for (unsigned int k = 1; k + 1 < poly.size(); ++k)
      {
        const T a = turn(poly[0], poly[k], poly[k + 1]);
        A += a;
        for (unsigned int i = 0; i < 2; ++i)
          m[i] += a * (poly[0][i] + poly[k][i] + poly[k + 1][i]) / 3.;
      }
    m[0] /= A;
    m[1] /= A;

    const auto rule = MortarContact::simplex_rule<3>(setup.degree);
    for (unsigned int k = 0; k < poly.size(); ++k)
      for (const auto &q : rule)
        {
          const V2<T> &u = poly[k], &v = poly[(k + 1) % poly.size()];
          V2<T>        y;
          for (unsigned int i = 0; i < 2; ++i)
            y[i] = q.lambda[0] * m[i] + q.lambda[1] * u[i] + q.lambda[2] * v[i];
          const V2<T>      xi = inverse(s.n, ys, y), eta = inverse(p.n, yp, y);
          std::array<T, 4> N, N1, N2, M, M1, M2;
          shapes(s.n, xi, N, N1, N2);
          shapes(p.n, eta, M, M1, M2);

          // weight: area in the plane times J0/Jy
          T     j[2][2] = {{T(0.), T(0.)}, {T(0.), T(0.)}};
          V3<T> X1 = {{T(0.), T(0.), T(0.)}}, X2 = X1;
          for (unsigned int a = 0; a < s.n; ++a)
            {
              for (unsigned int i = 0; i < 2; ++i)
                {
                  j[i][0] += N1[a] * ys[a][i];
                  j[i][1] += N2[a] * ys[a][i];
                }
              for (unsigned int i = 0; i < 3; ++i)
                {
                  X1[i] += N1[a] * setup.reference[a][i];
                  X2[i] += N2[a] * setup.reference[a][i];
                }
            }
          const V3<T> XX = cross(X1, X2);
          const T     W  = q.weight * turn(m, u, v) / 2. * sqrt(dot(XX, XX)) /
                      (j[0][0] * j[1][1] - j[0][1] * j[1][0]);

          const V3<T> xs = sum(s, N), xp = sum(p, M);
          const T     dist = dot(n, sub(xs, xp));
          T level = T(0.), ls = T(0.), cs = T(0.), lp = T(0.), cp = T(0.);
          for (unsigned int a = 0; a < s.n; ++a)
            {
              level += N[a] * setup.level[a];
              ls += N[a] * s.length[a];
              cs += N[a] * s.compliance[a];
            }
          for (unsigned int a = 0; a < p.n; ++a)
            {
              lp += M[a] * p.length[a];
              cp += M[a] * p.compliance[a];
            }
          T d = dist + setup.gap_shift;
          if (value(level) > 0.)
            d -= setup.share * level;
          if (value(d) <= 0.)
            continue;
          T l = ls, K = ls / cs;
          if (setup.series)
            {
              l = (cs * ls + cp * lp) / (cs + cp);
              K = l / (cs + cp);
            }
          const V3<T>  t1 = sum(p, M1), t2 = sum(p, M2);
          const V3<T>  mm     = cross(t1, t2);
          T            cosine = -dot(n, mm) / sqrt(dot(mm, mm));
          T            facing = T(1.);
          const double c0 = std::cos(80. * M_PI / 180.), c1 = 0.5;
          if (value(cosine) <= c0)
            continue;
          if (value(cosine) < c1)
            {
              const T t = (cosine - c0) / (c1 - c0);
              facing    = t * t * (3. - 2. * t);
            }
          const T force = W * facing * pressure(setup, d, K, l);

          // (2.a): dd = a . (dx_s - dx_p - dist dn), a = mm / (mm . n)
          const T mn = dot(mm, n);
          V3<T>   a  = {{mm[0] / mn, mm[1] / mn, mm[2] / mn}};
          // a . dn = Pa . dw / |w|, dw = dp x q + p x dq
          const T               an   = dot(a, n);
          const V3<T>           Pa   = {{(a[0] - an * n[0]) / wl,
                                         (a[1] - an * n[1]) / wl,
                                         (a[2] - an * n[2]) / wl}};
          const V3<T>           by_p = cross(qq, Pa), by_q = cross(Pa, pp);
          std::array<double, 4> pc, qc;
          if (s.n == 3)
            {
              pc = {{-1., 1., 0., 0.}};
              qc = {{-1., 0., 1., 0.}};
            }
          else
            {
              pc = {{-1., 0., 1., 0.}};
              qc = {{0., -1., 0., 1.}};
            }
          for (unsigned int b = 0; b < s.n; ++b)
            for (unsigned int i = 0; i < 3; ++i)
              f[3 * b + i] +=
                force *
                (N[b] * a[i] - dist * (pc[b] * by_p[i] + qc[b] * by_q[i]));
          for (unsigned int b = 0; b < p.n; ++b)
            for (unsigned int i = 0; i < 3; ++i)
              f[12 + 3 * b + i] -= force * M[b] * a[i];
        }
    return f;
  }
} // namespace Oracle

#endif
