(define (problem test-13)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b4) (clear b2) (clear b5)
    (on b3 b1) (on b2 b3) (on b5 b4))
  (:goal (and
    (on b1 b3) (on b5 b4))))
