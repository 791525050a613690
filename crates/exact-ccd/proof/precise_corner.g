# a component of a corner in twice the precision
# n is a value as it is computed, e without any rounding. Written by a test: see gappa.rs.
e24 = x3 - x0;
n24 = (x3 - x0) + (x3 * a24 + x0 * b24);
e37 = e24 * p0;
n37 = (n24 * p0) + ((n24 * p0) * a37);
e38 = x0 + e37;
n38 = (x0 + n37) + (x0 * a38 + n37 * b38);
{ |x0| <= 1 /\
  |x3| <= 1 /\
  |a24| <= 1b-100 /\
  |b24| <= 1b-100 /\
  |a37| <= 1b-100 /\
  |a38| <= 1b-100 /\
  |b38| <= 1b-100 /\
  |e38| <= 1 /\
  p0 in [0, 1] /\
  p1 in [0, 1] /\
  p2 in [0, 1]
  -> |n38 - e38| <= 8b-100 }
n24 - e24 -> ((x3 - x3) - (x0 - x0)) + (x3 * a24 + x0 * b24);
n37 - e37 -> ((n24 - e24) * p0 + e24 * (p0 - p0) + (n24 - e24) * (p0 - p0)) + ((n24 * p0) * a37);
n38 - e38 -> ((x0 - x0) + (n37 - e37)) + (x0 * a38 + n37 * b38);
