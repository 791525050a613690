# A sum in twice the precision, relative to the larger operand a, scaled to a head in [1, 2]: Add of DoubleDouble.
# The sum of the heads and the last sum are exact transformations: h + e is ah + bh, and the result is h + low.
@rnd = float<ieee_64, ne>;
h = rnd(ah + bh);
e = ah + bh - h;
t = rnd(al + bl);
low = rnd(e + t);
{ ah in [1, 2] /\ |bh| <= 2 /\ |al| <= 1b-53 /\ |bl| <= 1b-53
  -> |(h + low) - ((ah + al) + (bh + bl))| <= 1b-102 }
(h + low) - ((ah + al) + (bh + bl)) -> (low - (e + t)) + (t - (al + bl));
