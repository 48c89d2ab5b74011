// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_search_pair_filter_h
#define mortar_contact_search_pair_filter_h

#include <mortar_contact/geometry/skin.h>

#include <vector>

namespace MortarContact
{
  /// Says which pairs of facets can be in contact at all.
  template <int dim>
  class PairFilter
  {
  public:
    /// Facets may turn a little before the next search: pairs up to this far
    /// (as a cosine) beyond the limit stay candidates.
    static constexpr double turning = 0.35;

    PairFilter(const Skin<dim> &secondary,
               const Skin<dim> &primary,
               const double     zero_cosine)
      : secondary(secondary)
      , primary(primary)
      , limit(zero_cosine - turning)
    {
      for (const auto &f : secondary.facets)
        normals_s.push_back(unit_normal(f.current));
      for (const auto &f : primary.facets)
        normals_p.push_back(unit_normal(f.current));
    }

    /// Whether the facets face each other, nearly, and share no vertex.
    bool
    may_touch(const unsigned int s, const unsigned int p) const
    {
      return -(normals_s[s] * normals_p[p]) > limit &&
             !share_vertex(secondary, s, primary, p);
    }

    /// Whether the facets face each other now: pairs that do not carry no
    /// force, whatever their distance.
    bool
    face_each_other(const unsigned int s, const unsigned int p) const
    {
      return -(normals_s[s] * normals_p[p]) > limit + turning &&
             !share_vertex(secondary, s, primary, p);
    }

    static bool
    share_vertex(const Skin<dim>   &secondary,
                 const unsigned int s,
                 const Skin<dim>   &primary,
                 const unsigned int p)
    {
      for (unsigned int a = 0; a < secondary.facets[s].current.n_vertices; ++a)
        for (unsigned int b = 0; b < primary.facets[p].current.n_vertices; ++b)
          if (secondary.vertices[s][a] == primary.vertices[p][b])
            return true;
      return false;
    }

  private:
    static Tensor<1, dim>
    unit_normal(const Facet<dim> &facet)
    {
      const Tensor<1, dim> w = centre_normal(facet);
      return w / w.norm();
    }

    const Skin<dim>            &secondary;
    const Skin<dim>            &primary;
    const double                limit;
    std::vector<Tensor<1, dim>> normals_s, normals_p;
  };
} // namespace MortarContact

#endif
