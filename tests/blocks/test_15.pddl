(define (problem test-15)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b5) (on-table b2) (clear b4)
    (clear b7) (clear b2) (on b3 b1) (on b6 b3) (on b4 b6) (on b7 b5))
  (:goal (and
    (on b6 b3) (on b4 b6) (on b2 b4) (on b7 b2))))
