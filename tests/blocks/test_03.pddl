(define (problem test-03)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 - block)
  (:init
    (hand-empty) (on-table b6) (on-table b5) (clear b1) (clear b7)
    (on b2 b6) (on b3 b2) (on b1 b3) (on b4 b5) (on b7 b4))
  (:goal (and
    (on b5 b3) (on b2 b5) (on b4 b7) (on b1 b4))))
