(define (problem test-10)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b5) (clear b2) (clear b6)
    (on b1 b4) (on b3 b1) (on b2 b3) (on b6 b5))
  (:goal (and
    (on b1 b5) (on b3 b2))))
