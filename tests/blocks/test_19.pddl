(define (problem test-19)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b3) (on-table b2) (clear b5)
    (clear b3) (clear b6) (on b1 b4) (on b5 b1) (on b7 b2) (on b6 b7))
  (:goal (and
    (on b3 b7) (on b2 b1) (on b4 b2) (on b6 b5))))
