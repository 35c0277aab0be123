#include "core/Links.h"

#include <gtest/gtest.h>

#include <string>

namespace velum {
namespace {

TEST(Links, AreReadAsTheirWords) {
  EXPECT_EQ(withoutLinks("Spike, see [UniProt P03377](https://www.uniprot.org/P03377), trimer"),
            "Spike, see UniProt P03377, trimer");
  EXPECT_EQ(withoutLinks("[a](http://x.org/a_(b)) and [c](www.y.org \"a title\")"), "a and c");
  EXPECT_EQ(withoutLinks("![picture](https://x.org/p.png)!"), "picture!");
  EXPECT_EQ(withoutLinks("[](https://x.org)"), "https://x.org") << "what has no words is its address";
  EXPECT_EQ(withoutLinks("<https://x.org/a>"), "https://x.org/a");
  EXPECT_EQ(withoutLinks("of <a href=\"https://x.org\" target=_blank>the <i>capsid</i></a>"), "of the capsid");
  EXPECT_EQ(withoutLinks("one<br/>two &amp; <P>three &lt;b&gt;"), "one two &  three <b>");
  EXPECT_EQ(withoutLinks("[[a](https://x.org/1) b](https://x.org/2)"), "a b");
}

TEST(Links, WhatIsNoneStays) {
  for (const char* text : {"", "plain", "[4Fe-4S](2+)", "poly[(R)-3-hydroxybutyrate](n)", "a < b > c", "<5 kDa", "R&D;",
                           "[open", "[a](b", "[a]", "!", "![", "<", "https://x.org/[a]", "\xce\xb2-actin [3]"})
    EXPECT_EQ(withoutLinks(text), text);
  EXPECT_EQ(withoutLinks(std::string(20000, '[')), std::string(20000, '[')) << "and in a moment";
}

}  // namespace
}  // namespace velum
