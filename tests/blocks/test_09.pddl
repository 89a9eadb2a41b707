(define (problem test-09)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b1) (clear b4) (on b2 b1) (on b5 b2) (on b3 b5)
    (on b4 b3))
  (:goal (and
    (on b3 b5) (on b4 b3) (on b2 b4))))
