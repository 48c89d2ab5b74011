// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/search/broad_phase.h>

#include <gtest/gtest.h>

#include <random>

using namespace MortarContact;

TEST(BroadPhase, FindsEveryBoxThatBruteForceFinds)
{
  std::mt19937                           rng(5);
  std::uniform_real_distribution<double> u(0., 1.);
  const auto                             random_box = [&]() {
    Box<3> b;
    for (unsigned int i = 0; i < 3; ++i)
      {
        b.low[i]  = u(rng);
        b.high[i] = b.low[i] + 0.1 * u(rng);
      }
    return b;
  };
  std::vector<Box<3>> boxes;
  for (unsigned int i = 0; i < 500; ++i)
    boxes.push_back(random_box());
  const BroadPhase<3> broad_phase(boxes);
  for (unsigned int k = 0; k < 100; ++k)
    {
      const Box<3>              query = random_box();
      std::vector<unsigned int> expected;
      for (unsigned int i = 0; i < boxes.size(); ++i)
        {
          bool overlap = true;
          for (unsigned int c = 0; c < 3; ++c)
            overlap = overlap && boxes[i].low[c] <= query.high[c] &&
                      query.low[c] <= boxes[i].high[c];
          if (overlap)
            expected.push_back(i);
        }
      EXPECT_EQ(broad_phase.find(query), expected);
    }
}

TEST(BroadPhase, EmptySetFindsNothing)
{
  EXPECT_TRUE(BroadPhase<2>({}).find(Box<2>()).empty());
}
