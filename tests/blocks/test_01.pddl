(define (problem test-01)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b3) (on-table b4) (on-table b1) (clear b2)
    (clear b5) (clear b1) (on b2 b3) (on b5 b4))
  (:goal (and
    (on b5 b2) (on b4 b5))))
