// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/UniqueNames.h"

#include <gtest/gtest.h>

namespace TestUniqueNames
{
using hexsweep::uniqueNames;
using Names = std::vector<std::string>;

TEST(UniqueNames, ThoseThatDifferStay)
{
  EXPECT_EQ(uniqueNames({ "inlet", "outlet" }, { " 1", " 2" }, 80), (Names{ "inlet", "outlet" }));
}

TEST(UniqueNames, EqualOnesGetTheirSuffixWhateverTheirCase)
{
  EXPECT_EQ(uniqueNames({ "hole", "wall", "Hole", "hole" }, { " 1", " 2", " 3", " 4" }, 80),
    (Names{ "hole 1", "wall", "Hole 3", "hole 4" }));
}

TEST(UniqueNames, ASuffixThatMakesANewPairIsNotTheEnd)
{
  const Names names = uniqueNames({ "a", "a", "a 1" }, { " 1", " 2", " 3" }, 80);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 3u);
}

TEST(UniqueNames, WithoutSuffixANameStaysAndTheOtherYields)
{
  EXPECT_EQ(uniqueNames({ "source", "Source" }, { " 4", "" }, 80), (Names{ "source 4", "Source" }));
}

TEST(UniqueNames, LongOnesAreCutBeforeTheSuffixAndBetweenCharacters)
{
  const std::string umlaut = "\xC3\xA4"; // two bytes
  EXPECT_EQ(uniqueNames({ "abc" + umlaut }, { " 1" }, 4), (Names{ "abc" }));
  EXPECT_EQ(
    uniqueNames({ "abcdefX", "abcdefY" }, { "_1", "_2" }, 6), (Names{ "abcd_1", "abcd_2" }));
}
}
