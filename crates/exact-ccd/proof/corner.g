# a component of a corner
# n is a value as it is computed, e without any rounding. Written by a test: see gappa.rs.
@rnd = float<ieee_64, ne>;
n1 = rnd(x0);
n7 = rnd(x6);
e48 = x6 - x0;
n48 = rnd(n7 - n1);
e61 = e48 * p0;
n61 = rnd(n48 * p0);
e62 = x0 + e61;
n62 = rnd(n1 + n61);
{ |x0| <= 1 /\
  |x6| <= 1 /\
  |e62| <= 1 /\
  p0 in [0, 1] /\
  p1 in [0, 1] /\
  p2 in [0, 1]
  -> |n62 - e62| <= 5b-53 }
