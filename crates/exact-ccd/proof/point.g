# a component of F
# n is a value as it is computed, e without any rounding. Written by a test: see gappa.rs.
@rnd = float<ieee_64, ne>;
n1 = rnd(x0);
n7 = rnd(x6);
n13 = rnd(x12);
n19 = rnd(x18);
n25 = rnd(x24);
n31 = rnd(x30);
e48 = x6 - x0;
n48 = rnd(n7 - n1);
e51 = x18 - x12;
n51 = rnd(n19 - n13);
e54 = x30 - x24;
n54 = rnd(n31 - n25);
e61 = e48 * p0;
n61 = rnd(n48 * p0);
e62 = x0 + e61;
n62 = rnd(n1 + n61);
e70 = e51 * p0;
n70 = rnd(n51 * p0);
e71 = x12 + e70;
n71 = rnd(n13 + n70);
e79 = e54 * p0;
n79 = rnd(n54 * p0);
e80 = x24 + e79;
n80 = rnd(n25 + n79);
e96 = e80 - e62;
n96 = rnd(n80 - n62);
e99 = e71 - e62;
n99 = rnd(n71 - n62);
e103 = e96 * p1;
n103 = rnd(n96 * p1);
e109 = e99 * p2;
n109 = rnd(n99 * p2);
e110 = e103 + e109;
n110 = rnd(n103 + n109);
e117 = e62 + e110;
n117 = rnd(n62 + n110);
{ |x0| <= 1 /\
  |x6| <= 1 /\
  |x12| <= 1 /\
  |x18| <= 1 /\
  |x24| <= 1 /\
  |x30| <= 1 /\
  |e62| <= 1 /\
  |e71| <= 1 /\
  |e80| <= 1 /\
  p0 in [0, 1] /\
  p1 in [0, 1] /\
  p2 in [0, 1]
  -> |n117 - e117| <= 39b-53 }
