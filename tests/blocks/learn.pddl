(define (problem learn)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b2) (on-table b4) (on-table b3) (clear b5)
    (clear b4) (clear b1) (on b5 b2) (on b1 b3))
  (:goal (and
    (on b1 b2) (on b3 b1) (on b4 b3) (on b5 b4))))
