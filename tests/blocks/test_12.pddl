(define (problem test-12)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b3) (on-table b4) (clear b6)
    (clear b3) (clear b4) (on b2 b1) (on b8 b2) (on b7 b8) (on b5 b7)
    (on b6 b5))
  (:goal (and
    (on b4 b5) (on b8 b2) (on b7 b8) (on b1 b6))))
