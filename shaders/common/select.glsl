// Choosing by number.
/// One of eight by selections: what is indexed by a variable would have to lie in memory.
float oneOf(float v0, float v1, float v2, float v3, float v4, float v5, float v6, float v7, int i) {
  bool odd = (i & 1) != 0;
  float a = odd ? v1 : v0;
  float b = odd ? v3 : v2;
  float c = odd ? v5 : v4;
  float d = odd ? v7 : v6;
  bool second = (i & 2) != 0;
  a = second ? b : a;
  c = second ? d : c;
  return (i & 4) != 0 ? c : a;
}
