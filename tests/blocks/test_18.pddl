(define (problem test-18)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b3) (on-table b2) (on-table b6)
    (clear b1) (clear b3) (clear b2) (clear b6) (on b5 b4) (on b1 b5))
  (:goal (and
    (on b2 b6) (on b1 b2) (on b5 b1) (on b3 b4))))
