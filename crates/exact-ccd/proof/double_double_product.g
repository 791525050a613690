# A product in twice the precision, relative to the factors a and b, scaled to heads in [1, 2]: Mul of DoubleDouble.
# The product of the heads and the last sum are exact transformations (Dekker 1971): h + e is ah bh, and the result is
# h + low.
@rnd = float<ieee_64, ne>;
h = rnd(ah * bh);
e = ah * bh - h;
t = rnd(rnd(ah * bl) + rnd(al * bh));
low = rnd(e + t);
{ ah in [1, 2] /\ bh in [1, 2] /\ |al| <= 1b-53 /\ |bl| <= 1b-53
  -> |(h + low) - (ah + al) * (bh + bl)| <= 1b-102 }
(h + low) - (ah + al) * (bh + bl) -> (low - (e + t)) + (t - (ah * bl + al * bh)) - al * bl;
