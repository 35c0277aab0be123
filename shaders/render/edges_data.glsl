// Edges of data and surfaces, by Sobel's kernel.

// A jump of depth begins to count where it is longer than finish.stepLength, and than so many pixels.
const float kStepPixels = 3.0;
// Where one instance of a type ends and another one begins, as a share of the line between types.
const float kWithinType = 0.6;
// How far a normal turns between two sides of a pixel before it is a crease. Noise bends them within a side, too.
const float kLeastCrease = 0.35;
const float kFullCrease = 0.95;

/// Depths that lie on a plane have none. @param bend  second difference of depths
float jumpOf(vec2 bend, float depth) {
  bool isFlat = hasFlag(kFlagOrthographic);
  float along = isFlat ? depth : 1.0 / max(depth, 1e-9);
  float pixel = 2.0 * length(frame.up.xyz) / frame.pictureSize.y * (isFlat ? 1.0 : along);
  float least = max(finish.stepLength, kStepPixels * pixel * float(finish.reach));
  return smoothstep(least, 2.0 * least, length(bend) * (isFlat ? 1.0 : along * along));
}

/// What a neighbour says: written out rather than looped over, as a loop that is not unrolled keeps its values in memory.
struct Neighbour {
  float solid;
  float differs;  // another structure
  float depth;    // that of the pixel where there is none
  vec2 normal;
};

Neighbour neighbourAt(ivec2 pixel, ivec2 last, Sample centre, float own) {
  Sample s = unpackSample(texelFetch(sampleTexture, clamp(pixel, ivec2(0), last), 0));
  float solid = solidity(s);
  bool same = isSame(s, centre);
  float both = min(own, solid);
  float weight = (s.ids & 0xffffu) == (centre.ids & 0xffffu) && (s.ids & 0xffffu) != 0u ? kWithinType : 1.0;
  return Neighbour(solid, same ? 0.0 : both * weight, both > 0.5 ? s.depth : centre.depth, both > 0.5 && same ? s.normal : centre.normal);
}

float middleOf(float x, float y, float z) { return max(min(x, y), min(max(x, y), z)); }

/// The edges next to a pixel by Sobel's kernel: of the outline, between structures, of depth and normals; 0..1.
float edgeAt(ivec2 pixel, Sample centre) {
  ivec2 last = textureSize(sampleTexture, 0) - 1;
  float own = solidity(centre);
  ivec2 x = ivec2(finish.reach, 0);
  ivec2 y = ivec2(0, finish.reach);
  Neighbour a = neighbourAt(pixel - x - y, last, centre, own);
  Neighbour b = neighbourAt(pixel - y, last, centre, own);
  Neighbour c = neighbourAt(pixel + x - y, last, centre, own);
  Neighbour d = neighbourAt(pixel - x, last, centre, own);
  Neighbour e = neighbourAt(pixel + x, last, centre, own);
  Neighbour f = neighbourAt(pixel - x + y, last, centre, own);
  Neighbour g = neighbourAt(pixel + y, last, centre, own);
  Neighbour h = neighbourAt(pixel + x + y, last, centre, own);
  vec2 outline = vec2(c.solid + 2.0 * e.solid + h.solid - a.solid - 2.0 * d.solid - f.solid, f.solid + 2.0 * g.solid + h.solid - a.solid - 2.0 * b.solid - c.solid);
  vec2 between = vec2(c.differs + 2.0 * e.differs + h.differs - a.differs - 2.0 * d.differs - f.differs, f.differs + 2.0 * g.differs + h.differs - a.differs - 2.0 * b.differs - c.differs);
  // What one of the eight alone sees is smaller than the line: it would be inked eight times around itself.
  vec2 others = vec2(abs(a.solid - own) + abs(b.solid - own) + abs(c.solid - own) + abs(d.solid - own) + abs(e.solid - own) + abs(f.solid - own) + abs(g.solid - own) + abs(h.solid - own),
                     a.differs + b.differs + c.differs + d.differs + e.differs + f.differs + g.differs + h.differs);
  vec2 isSeen = smoothstep(vec2(1.0, kWithinType), vec2(2.0, 2.0 * kWithinType), others);
  vec2 before = vec2(middleOf(a.depth, d.depth, f.depth), middleOf(a.depth, b.depth, c.depth)) - centre.depth;
  vec2 after = vec2(middleOf(c.depth, e.depth, h.depth), middleOf(f.depth, g.depth, h.depth)) - centre.depth;
  vec2 bend = before + after;
  // How much the normal turns across the pixel, less what noise makes it turn along either side.
  vec2 across = c.normal + 2.0 * e.normal + h.normal - a.normal - 2.0 * d.normal - f.normal;
  vec2 down = f.normal + 2.0 * g.normal + h.normal - a.normal - 2.0 * b.normal - c.normal;
  vec2 left = a.normal - 2.0 * d.normal + f.normal;
  vec2 right = c.normal - 2.0 * e.normal + h.normal;
  vec2 top = a.normal - 2.0 * b.normal + c.normal;
  vec2 bottom = f.normal - 2.0 * g.normal + h.normal;
  float rough = sqrt(dot(left, left) + dot(right, right) + dot(top, top) + dot(bottom, bottom));
  float turn = 0.25 * (sqrt(dot(across, across) + dot(down, down)) - rough);
  // A jump next to the outline is the outline's.
  float outlined = dot(outline, outline);
  float jump = outlined > 0.0 ? 0.0 : own * jumpOf(bend, centre.depth);
  // A line may be thinner than the pixels next to an edge.
  float share = min(1.0, 0.5 * finish.contourPixels / float(finish.reach));
  float edge = finish.steps * max(0.25 * isSeen.x * sqrt(outlined), jump);
  edge = max(edge, finish.structures * 0.25 * isSeen.y * length(between));
  return share * min(max(edge, finish.creases * own * smoothstep(kLeastCrease, kFullCrease, turn)), 1.0);
}
