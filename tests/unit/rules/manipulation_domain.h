#pragma once

namespace cell::rules {

/// Blocks that an arm grabs and puts on others: what a grab or a put does by
/// chance to a block beside is unpredictable (a small robot manipulation
/// domain in the style of Pasula et al.).
inline constexpr char kManipulationRules[] = R"(
grab 1 action binary
puton 1 action binary
table 1 primitive binary
block 1 primitive binary
on 2 primitive binary
inhand 1 primitive binary
upright 1 primitive binary
size 1 primitive integers
clear 1 conjunction binary <-- All Y -on(Y X)
inhandNil 0 conjunction binary <-- All X -inhand(X)
above 2 transclosure binary <-- + on
aboveNotable 2 conjunction binary <-- above(X Y) -table(Y)
height 1 count integers <-- Num Y aboveNotable(X Y)
sum_height 0 sum integers <-- Sum height

Action: grab(X)
References: Y: on(X, Y)
Preconditions: block(X), inhandNil(), clear(X)
Effects:
  0.85: inhand(X), not on(X, Y), not upright(X)
  0.15: noise

Action: grab(X)
References: Y: on(X, Y); Z: on(Z, X), clear(Z); T: table(T)
Preconditions: block(X), inhandNil(), not clear(X)
Effects:
  0.6: inhand(X), not on(X, Y), not upright(X), not on(Z, X), on(Z, T), not upright(Z)
  0.3: nothing
  0.1: noise

Action: puton(X)
References: Z: inhand(Z)
Preconditions: clear(X), not inhand(X)
Effects:
  0.8: on(Z, X), not inhand(Z), upright(Z)
  0.2: noise

Action: puton(X)
References: Z: inhand(Z); T: table(T)
Preconditions: not clear(X), block(X)
Effects:
  0.7: on(Z, T), not inhand(Z)
  0.3: noise
)";

inline constexpr char kManipulationState[] =
    "table(t) block(a) block(b) block(c) block(d) block(e) block(f) size(t)=4 "
    "size(a)=3 size(b)=3 size(c)=3 size(d)=2 size(e)=3 size(f)=2 on(a t) "
    "on(b t) on(c t) on(d t) on(e d) on(f e) upright(a) upright(b) upright(c) "
    "upright(d) upright(e) upright(f)";
inline constexpr char kManipulationObjects[] = "tabcdef";

}  // namespace cell::rules
